// Surfaces, unpacked.
const bytesOf = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));

const meshShader = {
  vertex: `#version 300 es
in vec3 place, normal; uniform mat4 matrix; out vec3 n, p;
void main() { n = normal; p = place; gl_Position = matrix * vec4(place, 1.); }`,
  fragment: `#version 300 es
precision highp float;
in vec3 n, p; uniform vec3 eye, tint, u, v; uniform float opaque, squares; out vec4 colour;
void main() {
  vec3 toEye = normalize(eye - p), m = normalize(n);
  if (dot(m, toEye) < 0.) m = -m;
  vec3 lamp = normalize(toEye + vec3(.25, .55, .1));
  float light = .5 + .5 * max(dot(m, lamp), 0.);
  vec3 base = tint;
  if (squares > .5) {
    float k = mod(floor(dot(p, u)) + floor(dot(p, v)), 2.);
    base = mix(tint, vec3(1.), k * .35 + .15);
  }
  float edge = pow(1. - abs(dot(m, toEye)), 3.);
  float shine = .25 * pow(max(dot(m, normalize(lamp + toEye)), 0.), 60.);
  colour = vec4(base * light * (1. - .45 * edge * (1. - opaque)) + shine, min(1., opaque + .5 * edge * (1. - opaque)));
}`,
};

const meshOf = surface => {
  const packed = new Uint16Array(bytesOf(surface.corners).buffer), bytes = bytesOf(surface.triangles).buffer;
  const triangles = surface.wide ? new Uint32Array(bytes) : new Uint16Array(bytes);
  const places = new Float32Array(packed.length), normals = new Float32Array(packed.length);
  for (let i = 0; i < packed.length; ++i)
    places[i] = surface.low[i % 3] + packed[i] / 65535 * (surface.high[i % 3] - surface.low[i % 3]);
  const corner = i => places.subarray(3 * i, 3 * i + 3);
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [corner(triangles[i]), corner(triangles[i + 1]), corner(triangles[i + 2])];
    const [px, py, pz, qx, qy, qz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2], c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    const n = [py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx];
    for (let k = 0; k < 3; ++k)
      for (let axis = 0; axis < 3; ++axis) normals[3 * triangles[i + k] + axis] += n[axis];
  }
  const middle = [0, 1, 2].map(axis => (surface.low[axis] + surface.high[axis]) / 2);
  return { surface, places, normals, triangles, middle, facing: normals.subarray(0, 3), look: surface.clear ? 'clear' : surface.squares ? 'solid' : 'half' };
};
