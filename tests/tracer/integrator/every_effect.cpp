#include "tests/tracer/integrator/every_effect.h"

#include "data/nff.h"

namespace rayshoot::tracer_tests {

Scene every_effect() {
    return read_nff(R"(
v
from 0 2 8
at 0 0.8 0
up 0 1 0
angle 35
hither 0
resolution 64 48
b 0.1 0.12 0.15
lens focal 0.4 stop 2 focus 8 blades 5
vmove 0 0 0  0.05 0.02 0

surface lambert colour 0.7 0.7 0.65
p 4
-5 0 -5
-5 0 5
5 0 5
5 0 -5
surface oren_nayar colour 0.6 0.4 0.3 roughness 0.5
s -2.4 0.5 0 0.5
surface phong colour 0.3 0.6 0.3 diffuse 0.6 specular 0.3 shine 30
s -1.2 0.5 0 0.5
surface cook_torrance colour 0.7 0.2 0.2 specular 1 index 1.5 roughness 0.2
s 0 0.5 0.4 0.5
surface conductor roughness 0.15
s 1.2 0.5 0 0.5
surface dielectric index 1.5
s 2.4 0.5 0.6 0.5
surface dielectric index 1.3 roughness 0.2
c 3.2 0 -0.5 0.3 3.2 1 -0.5 0.2
surface nff colour 0.8 0.8 0.9 diffuse 0.3 specular 0.5 shine 50 gloss 80
s -0.6 1.6 -1 0.5
f 0.9 0.9 0.9 0.2 0.2 20 0.6 1.4
move 0 0 0  0.5 0.3 0
s 0.7 1.7 -0.5 0.4
rest
f 0.8 0.6 0.2 0.8 0.2 10 0 1
turn -1.8 1.6 -0.5  0 0 1  0 60
c -1.8 1.2 -0.5 0.15 -1.8 2 -0.5 0.05
rest
surface lambert colour 0 0 0 emission 2 1 0.5
p 3
-3 0.1 2
-2 0.1 2
-2.5 0.8 2

l 4 5 6 0.4 0.4 0.4
light point -4 5 4  20 20 22
light directional 1 -1 -0.5  0.3 0.3 0.25
light spot 0 5 2  0 -1 -0.2  10 25  30 25 20
light rectangle -1 4 -2  2 0 0  0 0 2  4 4 4 visible strata 2 2
light disc 3 3 2  -1 -1 -0.5  0.4  6 6 8
light sphere -3 3 1  0.3  8 7 5 visible
)",
                    "every_effect.nff");
}

}  // namespace rayshoot::tracer_tests
