# The same scene for rayscope and for POV-Ray: awk -v kind=flake|bowls -v form=nff|toml|pov -v n=N -f scenes.awk
# flake: Haines' sphereflake of depth n, 1 + 9 + … spheres (balls of the Standard Procedural Databases); nff or pov.
# bowls: n × n bowls (outer − inner) − cone on a floor; toml or pov.

function vec(x, y, z) { return sprintf(form == "pov" ? "<%.9g,%.9g,%.9g>" : "%.9g %.9g %.9g", x, y, z) }

function sphere(x, y, z, r) {
    if (form == "pov") printf "sphere{%s,%.9g texture{T}}\n", vec(x, y, z), r
    else printf "s %s %.9g\n", vec(x, y, z), r
}

# Nine children around each ball: six on its equator, three above; `d` is its axis, `e` and `f` complete a frame.
function ball(level, x, y, z, r, dx, dy, dz,    l, ex, ey, ez, fx, fy, fz, i, a, s, c, h, cx, cy, cz, q) {
    sphere(x, y, z, r)
    if (level == 0) return
    if (dx * dx < 0.5) { ex = 0; ey = dz; ez = -dy } else { ex = -dz; ey = 0; ez = dx }
    l = sqrt(ex * ex + ey * ey + ez * ez); ex /= l; ey /= l; ez /= l
    fx = dy * ez - dz * ey; fy = dz * ex - dx * ez; fz = dx * ey - dy * ex
    q = r / 3
    for (i = 0; i < 9; ++i) {
        a = i < 6 ? i * pi / 3 : (i - 6) * 2 * pi / 3 + pi / 6
        h = i < 6 ? 0 : sin(pi / 3); s = sqrt(1 - h * h)
        c = cos(a) * s; s = sin(a) * s
        cx = c * ex + s * fx + h * dx; cy = c * ey + s * fy + h * dy; cz = c * ez + s * fz + h * dz
        ball(level - 1, x + (r + q) * cx, y + (r + q) * cy, z + (r + q) * cz, q, cx, cy, cz)
    }
}

function flake() {
    if (form == "pov") {
        print "#version 3.7; global_settings{max_trace_level 5 adc_bailout 0 assumed_gamma 1}"
        print "background{rgb <.078,.361,.753>}"
        print "camera{perspective location <2.1,1.3,1.7> sky z right -x angle 45 look_at 0}"
        print "light_source{<4,3,2> rgb .57735} light_source{<1,-4,4> rgb .57735} light_source{<-3,1,5> rgb .57735}"
        print "polygon{5,<12,12,-.5>,<-12,12,-.5>,<-12,-12,-.5>,<12,-12,-.5>,<12,12,-.5> pigment{rgb <1,.75,.33>} " \
              "finish{ambient 0 diffuse .8}}"
        print "#declare T=texture{pigment{rgb <1,.9,.7>} finish{ambient 0 diffuse .5 phong .5 phong_size 3.0827 " \
              "reflection{.5}}}"
    } else {
        print "b 0.078 0.361 0.753\nv\nfrom 2.1 1.3 1.7\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.01\nresolution 512 512"
        print "l 4 3 2\nl 1 -4 4\nl -3 1 5\nf 1 0.75 0.33 0.8 0 100000 0 1"
        print "p 4\n12 12 -0.5\n-12 12 -0.5\n-12 -12 -0.5\n12 -12 -0.5\nf 1 0.9 0.7 0.5 0.5 3.0827 0 1"
    }
    ball(n, 0, 0, 0, 0.5, 0, 0, 1)
}

function bowls(    size, i, j, x, z) {
    size = 2.4 * n
    if (form == "pov") {
        print "#version 3.7; global_settings{max_trace_level 5 adc_bailout 0 assumed_gamma 1}"
        print "background{rgb <.3,.4,.6>}"
        printf "camera{perspective location <0,%g,%g> sky y right -x angle 50 look_at 0}\n", .9 * size, 1.1 * size
        printf "light_source{<%g,%g,%g> rgb 1}\n", -size, 2 * size, size
        print "plane{y,-1.2 pigment{rgb .7} finish{ambient .1 diffuse .8}}"
        print "#declare Bowl=difference{difference{sphere{0,1} sphere{0,.85}} cone{<0,-.1,0>,0,<0,1.5,0>,1.6} " \
              "texture{pigment{rgb <.8,.6,.4>} finish{ambient .1 diffuse .7 phong .3 phong_size 40 reflection{.2}}}}"
    } else {
        printf "[camera]\neye=[0,%g,%g]\nlook_at=[0,0,0]\nfield_of_view=50\nresolution=[512,512]\n", .9 * size, 1.1 * size
        printf "[limits]\nmax_depth=4\nmin_weight=0\n[scene]\nbackground=[0.3,0.4,0.6]\n"
        printf "[lights.lamp]\nposition=[%g,%g,%g]\n", -size, 2 * size, size
        print "[materials.floor]\nambient=0.07\ndiffuse=0.56"
        print "[materials.clay]\nambient=[0.08,0.06,0.04]\ndiffuse=[0.56,0.42,0.28]\nspecular=0.3\nshininess=40\nreflection=0.2"
        print "[generics.floor]\nshape=\"plane\"\nmaterial=\"floor\"\ntransform=[{rotate_x=-90},{translate=[0,-1.2,0]}]"
        print "[generics.outer]\nshape=\"sphere\"\n[generics.inner]\nshape=\"sphere\"\ntransform=[{scale=0.85}]"
        print "[generics.mouth]\nshape=\"cone\"\ntransform=[{scale=[1.6,1.6,0.8]},{rotate_x=90},{translate=[0,0.7,0]}]"
    }
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j) {
            x = (i - (n - 1) / 2) * 2.4; z = (j - (n - 1) / 2) * 2.4
            if (form == "pov") printf "object{Bowl translate <%g,0,%g>}\n", x, z
            else printf "[compounds.bowl_%d_%d]\nis=\"(outer - inner) - mouth\"\nmaterial=\"clay\"\n" \
                        "transform=[{translate=[%g,0,%g]}]\n", i, j, x, z
        }
}

BEGIN {
    pi = atan2(0, -1)
    if (kind == "flake") flake()
    else bowls()
}
