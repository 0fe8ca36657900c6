// Square of 100 x 100 mm about the origin, meshed with triangles whose edges are `size` long, about. MeshAdapt
// (Algorithm 1) leaves the nodes without rows that could guide a crack; Gmsh's default makes a hexagonal lattice of them.
DefineConstant[ size = {0.0006, Name "size"} ];
Point(1) = {-0.05, -0.05, 0, size};
Point(2) = {0.05, -0.05, 0, size};
Point(3) = {0.05, 0.05, 0, size};
Point(4) = {-0.05, 0.05, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Mesh.Algorithm = 1;
Physical Surface("square", 1) = {1};
