// The plate with its hole cut out, or whole, in mm; run.sh sets which, and the height of the hole.
SetFactory("OpenCASCADE");
If (!Exists(Height))
  Height = 6;
EndIf
If (!Exists(IsCut))
  IsCut = 1;
EndIf
If (IsCut)
  Rectangle(1) = {0, -35, 0, 40, 70};
  Disk(2) = {20, Height, 0, 4};
  BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Else
  Rectangle(3) = {0, -35, 0, 40, 70};
EndIf
If (!Exists(Size))
  Size = 0.85;
EndIf
Mesh.MeshSizeMax = Size;
Mesh.MeshSizeMin = Size;
Physical Surface("plate") = {3};
