// Rays as lines of a width in pixels, each a strip of two triangles that the vertex shader turns towards the eye.
const lineShader = {
  vertex: `#version 300 es
in vec3 from, to; in vec4 colour; in vec4 place; // place: which end, which side, width, length so far
uniform mat4 matrix; uniform vec2 pixels;
out vec4 tint; out float along, dashed, side, wide;
void main() {
  vec4 a = matrix * vec4(from, 1.), b = matrix * vec4(to, 1.);
  if (a.w < 1e-3) a = mix(a, b, (1e-3 - a.w) / (b.w - a.w));
  if (b.w < 1e-3) b = mix(b, a, (1e-3 - b.w) / (a.w - b.w));
  vec2 p = a.xy / a.w * pixels, q = b.xy / b.w * pixels, d = q - p;
  d = length(d) > 1e-6 ? normalize(d) : vec2(1., 0.);
  vec4 here = mix(a, b, place.x);
  side = place.y * (abs(place.z) + 1.); wide = abs(place.z); // a pixel more, to fade in
  vec2 aside = vec2(-d.y, d.x) * side / pixels;
  gl_Position = here + vec4(aside * here.w, 0., 0.);
  tint = colour; along = place.w; dashed = place.z < 0. ? 1. : 0.;
}`,
  fragment: `#version 300 es
precision highp float;
in vec4 tint; in float along, dashed, side, wide; uniform float dash; out vec4 colour;
void main() {
  if (dashed > .5 && fract(along / dash) > .55) discard;
  colour = vec4(tint.rgb, tint.a * clamp(wide + .5 - abs(side), 0., 1.));
}`,
};

// Six vertices of 14 numbers a line.
const lineVertices = segments => {
  const data = new Float32Array(segments.length * 6 * 14);
  let at = 0;
  for (const { from, to, colour, width, dashed } of segments) {
    const long = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    for (const [end, side] of [[0, -1], [0, 1], [1, -1], [1, -1], [0, 1], [1, 1]]) {
      data.set([...from, ...to, ...colour, end, side, dashed ? -width : width, end * long], at);
      at += 14;
    }
  }
  return data;
};
