// The plate with its hole cut out, in mm; run.sh sets the height of the hole.
SetFactory("OpenCASCADE");
If (!Exists(Height))
  Height = 6;
EndIf
Rectangle(1) = {0, -35, 0, 40, 70};
Disk(2) = {20, Height, 0, 4};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Mesh.MeshSizeMax = 0.85;
Mesh.MeshSizeMin = 0.85;
Physical Surface("plate") = {3};
