// Half a sphere on half a block, cut in the plane of symmetry y = 0, of hexahedra
// that are finer where the two touch, in the origin. The sphere is a core with a
// volume below it, which touches the block, one above it, by which the sphere is
// held, and three around it. Mesh/Spheres keeps it round.
radius = 10;
n = 6;     // cells across half of the lower and of the upper volume
n_out = 3; // from the core to the surface
n_up = 5;  // from the lower volume to the upper one

Point(1) = {0, 0, radius};

// The patch of the sphere within an angle about the axis, below (up = -1) or
// above the centre, and a face of the core: corners, curves and surfaces.
Macro Patch
  For side In {0 : 3}
    x = Tan(angle) * ((side == 0 || side == 3) ? -1 : 1);
    y = Tan(angle) * (side > 1);
    length = Sqrt(x * x + y * y + 1);
    Point(first + side) = {radius * x / length, radius * y / length,
                           radius * (1 + up / length)};
    Point(first + 4 + side) = {radius * core * x, radius * core * y,
                               radius * (1 + core * up)};
  EndFor
  For side In {0 : 3}
    next = (side + 1) % 4;
    Circle(first + side) = {first + side, 1, first + next};
    Line(first + 4 + side) = {first + 4 + side, first + 4 + next};
    Line(first + 8 + side) = {first + side, first + 4 + side};
  EndFor
  Curve Loop(first) = {first : first + 3};
  Surface(first) = {first} In Sphere {1};
  Curve Loop(first + 4) = {first + 4 : first + 7};
  Surface(first + 4) = {first + 4};
  For side In {0 : 3}
    Curve Loop(first + 8 + side) = {first + side, first + 8 + (side + 1) % 4,
                                    -(first + 4 + side), -(first + 8 + side)};
    Surface(first + 8 + side) = {first + 8 + side};
  EndFor
Return
first = 100; angle = 18 * Pi / 180; up = -1; core = 0.6;
Call Patch;
first = 200; angle = 50 * Pi / 180; up = 1; core = 0.35;
Call Patch;

// Between them the sides of the core, the sphere but for y = 0, where the core
// ends, and the faces from the edges of the core to the sphere.
For side In {0 : 3}
  Circle(300 + side) = {100 + side, 1, 200 + side};
  Line(304 + side) = {104 + side, 204 + side};
EndFor
For side In {0 : 3}
  next = (side + 1) % 4;
  Curve Loop(304 + side) = {104 + side, 304 + next, -(204 + side), -(304 + side)};
  Surface(304 + side) = {304 + side};
  If (side > 0)
    Curve Loop(300 + side) = {100 + side, 300 + next, -(200 + side), -(300 + side)};
    Surface(300 + side) = {300 + side} In Sphere {1};
  EndIf
  Curve Loop(308 + side) = {300 + side, 208 + side, -(304 + side), -(108 + side)};
  Surface(308 + side) = {308 + side};
EndFor
Surface Loop(1) = {104, 204, 304 : 307};
Surface Loop(2) = {100, 104, 108 : 111};
Surface Loop(3) = {200, 204, 208 : 211};
For side In {1 : 3}
  Surface Loop(3 + side) = {300 + side, 304 + side, 108 + side, 208 + side,
                            308 + side, 308 + (side + 1) % 4};
EndFor
For volume In {1 : 6}
  Volume(volume) = {volume};
EndFor

Transfinite Curve {100, 102, 104, 106, 200, 202, 204, 206} = 2 * n + 1;
Transfinite Curve {101, 103, 105, 107, 201, 203, 205, 207} = n + 1;
Transfinite Curve {108 : 111} = n_out + 1 Using Progression 1.5;
Transfinite Curve {208 : 211} = n_out + 1;
Transfinite Curve {300 : 307} = n_up + 1 Using Progression 1.4;

// The block: 400 is its upper side, 404 the lower one, 408 is at y = 0.
For side In {0 : 3}
  x = (side == 0 || side == 3) ? -16 : 16;
  y = 16 * (side > 1);
  Point(400 + side) = {x, y, 0};
  Point(404 + side) = {x, y, -12};
EndFor
For side In {0 : 3}
  next = (side + 1) % 4;
  Line(400 + side) = {400 + side, 400 + next};
  Line(404 + side) = {404 + side, 404 + next};
  Line(408 + side) = {400 + side, 404 + side};
EndFor
For side In {0 : 3}
  Curve Loop(408 + side) = {400 + side, 408 + (side + 1) % 4, -(404 + side), -(408 + side)};
  Plane Surface(408 + side) = {408 + side};
EndFor
Curve Loop(400) = {400 : 403};
Plane Surface(400) = {400};
Curve Loop(404) = {404 : 407};
Plane Surface(404) = {404};
Surface Loop(7) = {400, 404, 408 : 411};
Volume(7) = {7};

Transfinite Curve {400, 402, 404, 406} = 2 * n + 9 Using Bump 12;
Transfinite Curve {401, -403, 405, -407} = n + 5 Using Progression 1.3;
Transfinite Curve {408 : 411} = n + 2 Using Progression 1.4;

Transfinite Surface{:};
Recombine Surface{:};
Transfinite Volume{:};

Physical Volume("Sphere") = {1 : 6};
Physical Volume("Block") = {7};
Physical Surface("Sphere symmetry") = {108, 208, 304, 308, 309};
Physical Surface("Sphere top") = {200};
Physical Surface("Sphere bottom") = {100};
Physical Surface("Sphere side") = {301 : 303};
Physical Surface("Block symmetry") = {408};
Physical Surface("Block top") = {400};
Physical Surface("Block bottom") = {404};
