# Scenes that any number of objects can be asked of: awk -v kind=flake|bowls -v n=N -f scenes.awk
# flake: Haines' sphereflake of depth n, 1 + 9 + … spheres (balls of the Standard Procedural Databases), as NFF.
# bowls: n × n bowls (outer − inner) − cone on a floor, as TOML.

# Nine children around each ball: six on its equator, three above; `d` is its axis, `e` and `f` complete a frame.
function ball(level, x, y, z, r, dx, dy, dz,    l, ex, ey, ez, fx, fy, fz, i, a, s, c, h, cx, cy, cz, q) {
    printf "s %.9g %.9g %.9g %.9g\n", x, y, z, r
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
    print "b 0.078 0.361 0.753\nv\nfrom 2.1 1.3 1.7\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.01\nresolution 512 512"
    print "l 4 3 2\nl 1 -4 4\nl -3 1 5\nf 1 0.75 0.33 0.8 0 100000 0 1"
    print "p 4\n12 12 -0.5\n-12 12 -0.5\n-12 -12 -0.5\n12 -12 -0.5\nf 1 0.9 0.7 0.5 0.5 3.0827 0 1"
    ball(n, 0, 0, 0, 0.5, 0, 0, 1)
}

function bowls(    size, i, j) {
    size = 2.4 * n
    printf "[camera]\neye=[0,%g,%g]\nlook_at=[0,0,0]\nfield_of_view=50\nresolution=[512,512]\n", .9 * size, 1.1 * size
    printf "[limits]\nmax_depth=4\nmin_weight=0\n[scene]\nbackground=[0.3,0.4,0.6]\n"
    printf "[lights.lamp]\nposition=[%g,%g,%g]\n", -size, 2 * size, size
    print "[materials.floor]\nambient=0.07\ndiffuse=0.56"
    print "[materials.clay]\nambient=[0.08,0.06,0.04]\ndiffuse=[0.56,0.42,0.28]\nspecular=0.3\nshininess=40\nreflection=0.2"
    print "[generics.floor]\nshape=\"plane\"\nmaterial=\"floor\"\ntransform=[{rotate_x=-90},{translate=[0,-1.2,0]}]"
    print "[generics.outer]\nshape=\"sphere\"\n[generics.inner]\nshape=\"sphere\"\ntransform=[{scale=0.85}]"
    print "[generics.mouth]\nshape=\"cone\"\ntransform=[{scale=[1.6,1.6,0.8]},{rotate_x=90},{translate=[0,0.7,0]}]"
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j)
            printf "[compounds.bowl_%d_%d]\nis=\"(outer - inner) - mouth\"\nmaterial=\"clay\"\n" \
                   "transform=[{translate=[%g,0,%g]}]\n", i, j, (i - (n - 1) / 2) * 2.4, (j - (n - 1) / 2) * 2.4
}

BEGIN {
    pi = atan2(0, -1)
    if (kind == "flake") flake()
    else bowls()
}
