// Plate of 200 x 100 mm, x from 0, y from -50 to 50 mm, in nx x ny equal quads. With an even ny the line y = 0 lies
// between two rows of elements, so that a crack along it cuts bonds and passes through no point.
//
//   gmsh -2 plate.geo -o plate.msh
//   gmsh -2 plate.geo -setnumber nx 74 -setnumber ny 38 -o coarse.msh
DefineConstant[ nx = {148, Name "nx"}, ny = {74, Name "ny"} ];
Point(1) = {0, -0.05, 0};
Point(2) = {0.2, -0.05, 0};
Point(3) = {0.2, 0.05, 0};
Point(4) = {0, 0.05, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1, 3} = nx + 1;
Transfinite Curve {2, 4} = ny + 1;
Transfinite Surface {1};
Recombine Surface {1};
Physical Surface("plate", 1) = {1};
Physical Curve("bottom", 2) = {1};
Physical Curve("right", 3) = {2};
Physical Curve("top", 4) = {3};
Physical Curve("left", 5) = {4};
