# Scenes that any number of objects can be asked of: awk -v kind=flake|glass|bowls|lenses|rings|mountain -v n=N -f scenes.awk
# flake: Haines' sphereflake of depth n, 1 + 9 + … spheres (balls of the Standard Procedural Databases), as NFF.
# glass: the same, its balls of glass that mirrors as well.
# bowls: n × n bowls (outer − inner) − cone on a floor, as TOML.
# lenses: n lenses, each what two spheres share, in rows of four on a floor, as TOML.
# rings: a pyramid of n steps of rings, each 30 spheres joined by 30 cylinders: 4,200 of both for n=7, as NFF.
# mountain: four balls of glass that touch each other above n × n squares, n a power of two, each cut into two triangles:
# 8,192 for n=64, as NFF.

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

function flake(material) {
    print "b 0.078 0.361 0.753\nv\nfrom 2.1 1.3 1.7\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.01\nresolution 512 512"
    print "l 4 3 2\nl 1 -4 4\nl -3 1 5\nf 1 0.75 0.33 0.8 0 100000 0 1"
    print "p 4\n12 12 -0.5\n-12 12 -0.5\n-12 -12 -0.5\n12 -12 -0.5\nf 1 0.9 0.7 " material
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

function lenses(    i) {
    print "[camera]\neye=[0,2.2,9]\nlook_at=[0,1.2,0]\nfield_of_view=40\nresolution=[512,512]"
    print "[limits]\nmax_depth=10\nmin_weight=0\n[scene]\nbackground=[0.4,0.5,0.7]"
    print "[lights.lamp]\nposition=[-4,8,6]\n[lights.other]\nposition=[5,6,3]\ncolour=0.4"
    print "[materials.floor]\nambient=0.07\ndiffuse=0.56"
    print "[materials.glass]\ndiffuse=0.05\nspecular=0.3\nshininess=40\nreflection=0.1\ntransmission=0.9\nindex=1.5"
    print "[generics.floor]\nshape=\"plane\"\nmaterial=\"floor\"\ntransform=[{rotate_x=-90}]"
    print "[generics.upper]\nshape=\"sphere\"\ntransform=[{scale=1.8},{translate=[0,1.5,0]}]"
    print "[generics.lower]\nshape=\"sphere\"\ntransform=[{scale=1.8},{translate=[0,-1.5,0]}]"
    for (i = 0; i < n; ++i)
        printf "[compounds.lens_%d]\nis=\"upper & lower\"\nmaterial=\"glass\"\n" \
               "transform=[{rotate_x=90},{translate=[%g,%g,%g]}]\n", i, (i % 4 - 1.5) * 2.1, 1.1 + int(i / 4) * 0.5, 2 - int(i / 4) * 3
}

function rings(    level, i, j, k, a, b, x, y, z) {
    print "b 0.078 0.361 0.753\nv\nfrom 9 7 16\nat 0 -1.5 0\nup 0 1 0\nangle 40\nhither 0.01\nresolution 512 512"
    print "l 10 12 8\nl -8 10 12\nl 2 14 -6\nf 0.9 0.75 0.4 0.7 0.3 10 0 1"
    print "p 4\n-30 -6 30\n30 -6 30\n30 -6 -30\n-30 -6 -30\nf 0.8 0.8 0.9 0.45 0.45 40 0 1"
    for (level = 1; level <= n; ++level)
        for (i = 0; i < level; ++i)
            for (j = 0; j < level; ++j) {
                x = (i - (level - 1) / 2) * 1.6; y = 3 - level * 1.1; z = (j - (level - 1) / 2) * 1.6
                for (k = 0; k < 30; ++k) {
                    a = k * pi / 15; b = (k + 1) * pi / 15
                    printf "s %.9g %.9g %.9g 0.08\n", x + 0.7 * cos(a), y + 0.15 * sin(3 * a), z + 0.7 * sin(a)
                    printf "c\n%.9g %.9g %.9g 0.04\n%.9g %.9g %.9g 0.04\n", x + 0.7 * cos(a), y + 0.15 * sin(3 * a),
                        z + 0.7 * sin(a), x + 0.7 * cos(b), y + 0.15 * sin(3 * b), z + 0.7 * sin(b)
                }
            }
}

# −1 … 1, the same everywhere (Park and Miller 1988).
function random() { seed = seed * 16807 % 2147483647; return seed / 1073741823.5 - 1 }

# Heights by halving the distance between known ones again and again, each time with half as much chance.
function mountain(    h, step, half, rough, x, y, i, s) {
    print "b 0.3 0.5 0.8\nv\nfrom 2 -1.7 1.9\nat 0.1 0 0.1\nup 0 0 1\nangle 45\nhither 0.01\nresolution 512 512"
    print "l 20 -60 80\nf 1 1 1 0.1 0.1 100 0.9 1.5"
    for (i = 0; i < 4; ++i) {
        s = i % 2 ? 1 : -1
        printf "s %.9g %.9g %.9g 0.17\n", 0.95 + (i < 2 ? s : -s) * 0.17 / sqrt(2), -0.8 + (i < 2 ? 1 : -1) * 0.17 / sqrt(2), 1 + s * 0.17 / sqrt(2)
    }
    print "f 0.5 0.45 0.35 1 0 100000 0 1"
    seed = 1
    for (step = n; step > 1; step = half) {
        half = step / 2; rough = 0.5 * step / n
        for (y = half; y < n; y += step)
            for (x = half; x < n; x += step)
                h[x, y] = (h[x - half, y - half] + h[x + half, y - half] + h[x - half, y + half] + h[x + half, y + half]) / 4 + rough * random()
        for (y = half; y < n; y += half)
            for (x = y % step ? step : half; x < n; x += step)
                h[x, y] = (h[x - half, y] + h[x + half, y] + h[x, y - half] + h[x, y + half]) / 4 + rough / 2 * random()
    }
    for (y = 0; y < n; ++y)
        for (x = 0; x < n; ++x) {
            printf "p 3\n%s\n%s\n%s\n", corner(h, x, y), corner(h, x + 1, y), corner(h, x + 1, y + 1)
            printf "p 3\n%s\n%s\n%s\n", corner(h, x, y), corner(h, x + 1, y + 1), corner(h, x, y + 1)
        }
}
function corner(h, x, y) { return sprintf("%.9g %.9g %.9g", 2 * x / n - 1, 2 * y / n - 1, h[x, y]) }

BEGIN {
    pi = atan2(0, -1)
    if (kind == "flake") flake("0.5 0.5 3.0827 0 1")
    else if (kind == "glass") flake("0.1 0.3 3.0827 0.7 1.5")
    else if (kind == "mountain") mountain()
    else if (kind == "lenses") lenses()
    else if (kind == "rings") rings()
    else bowls()
}
