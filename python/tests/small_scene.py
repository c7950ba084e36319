"""A glass ball on a table, of 24 x 16 pixels."""

import sunfleck

BALL = """
LookAt 0 -6 4  0 0 0.6  0 0 1
Camera "perspective" "float fov" 35
Film "rgb" "integer xresolution" 24 "integer yresolution" 16
WorldBegin
Material "diffuse" "rgb reflectance" [ .6 .5 .4 ]
Shape "trianglemesh" "point3 P" [ -4 -4 0 4 -4 0 4 4 0 -4 4 0 ] "integer indices" [ 0 1 2 0 2 3 ]
AttributeBegin
Translate 0 0 1.2
Material "dielectric" "float eta" 1.5
Shape "sphere" "float radius" 1
AttributeEnd
AttributeBegin
Translate -2 1 5
AreaLightSource "diffuse" "rgb L" [ 900 800 650 ]
Shape "sphere" "float radius" .1
AttributeEnd
"""


def quick(scene, **settings):
    return sunfleck.Renderer(scene, **{"photons_per_pass": 4000, "passes": 4, **settings})


def endless(scene, **settings):
    return quick(scene, **{"passes": 1000000, "photon_sampler": "uniform", **settings})
