// small.toml, written by rayscope export, for POV-Ray 3.7. At the size of rayscope's image:
//   povray +IFILE.pov +W320 +H240 -A File_Gamma=sRGB

#version 3.7;
global_settings {
  assumed_gamma 1
  ambient_light rgb 0.5
  max_trace_level 9
  adc_bailout 0.001
}
background { rgb <0.1, 0.2, 0.4> }
camera {
  perspective
  location <0, -8, 6>
  direction <0, 0.8, -0.6>
  right <0.5358983848622454, 0, 0> * image_width / image_height
  up <0, 0.3215390309173472, 0.4287187078897963>
}

// lamp
light_source { <4, -3, 6>, rgb 1 }

// sun
light_source { <0, 0, 5000000>, rgb <0.3, 0.3, 0.2> parallel point_at 0 }

// glass
#declare Material_1 =
texture {
  pigment { rgbf <1.6, 1.6, 1.6, 1> }
  finish { ambient 0 diffuse 0 }
}
texture {
  pigment { rgbt <1, 0.5, 1, 0.5> }
  finish { ambient rgb 0 diffuse 0.2 phong 0.5 phong_size 40 reflection { rgb 0.2 } }
}
#declare Inside_1 =
texture {
  pigment { rgbf <0.8, 0.8, 0.8, 1> }
  finish { ambient 0 diffuse 0 reflection { rgb 0.2 } }
}

// glass, lit like stone
#declare Material_2 =
texture {
  pigment { rgbf <1.6, 1.6, 1.6, 1> }
  finish { ambient 0 diffuse 0 }
}
texture {
  pigment { rgbt <1, 1, 1, 0.5> }
  finish { ambient rgb 0.2 diffuse 1 reflection { rgb 0.2 } }
}
#declare Inside_2 =
texture {
  pigment { rgbf <0.8, 0.8, 0.8, 1> }
  finish { ambient 0 diffuse 0 reflection { rgb 0.2 } }
}

// stone
#declare Material_3 =
texture {
  pigment { rgb 1 }
  finish { ambient rgb 0.1 diffuse 0.5 }
}

// bowl
difference {
  // outer
  sphere { <0, 0, 0>, 1 }
  // inner
  sphere { <0, 0, 0>, 0.75 texture { Material_2 } interior_texture { Inside_2 } }
  // cut
  plane { z, 0 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0.5> inverse }
  texture { Material_1 } interior_texture { Inside_1 } interior { ior 1.5 }
}

// ring
torus { 1, 0.25 sturm rotate 90*x matrix <0.5, 0, 0, 0, 0.5, 0, 0, 0, 1, 2, 0, 0> texture { Material_3 } }

// ground
polygon { 5, <-4, -4, -1>, <4, -4, -1>, <4, 4, -1>, <-4, 4, -1>, <-4, -4, -1> texture { Material_3 } }
