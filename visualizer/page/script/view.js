// The rays in space, in WebGL 2; the page is complete without it.
const view = (() => {
  const canvas = element('canvas'), gl = canvas.getContext('webgl2', { antialias: true, preserveDrawingBuffer: true });
  const ink = { eye: [0.13, 0.14, 0.16], reflected: [0, 0.45, 0.7], refracted: [0.84, 0.37, 0], shadow: [0.9, 0.62, 0] };
  const add = (a, b, k = 1) => [a[0] + b[0] * k, a[1] + b[1] * k, a[2] + b[2] * k];
  const sub = (a, b) => add(a, b, -1);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const unit = a => { const l = Math.hypot(...a) || 1; return a.map(c => c / l); };

  const up = unit(scene.up), east = unit(cross(up, Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 0, 1])), north = cross(up, east);
  const camera = { centre: scene.centre, distance: 3 * scene.radius, azimuth: 0.6, elevation: 0.4 };
  const back = () => add(add(east.map(c => c * Math.cos(camera.azimuth) * Math.cos(camera.elevation)), north, Math.sin(camera.azimuth) * Math.cos(camera.elevation)), up, Math.sin(camera.elevation));
  const eyePoint = () => add(camera.centre, back(), camera.distance);

  const endOfRay = ray => {
    const begun = start(ray), hit = find(ray, 'boundary_chosen');
    if (hit) return hit.point;
    const blocker = begun.kind === 'shadow' && find(ray, 'ray_finished')?.colour.every(c => c === 0) ? blockerOf(ray) : null;
    const t = blocker ? number(blocker.t) : number(begun.reach);
    return add(begun.origin, begun.direction, Number.isFinite(t) ? t : 1.2 * scene.radius);
  };

  // What is far outside is drawn as far as it can be seen.
  const shortened = ([from, to]) => {
    const far = 12 * scene.radius, d = sub(to, from), long = Math.hypot(...d);
    const away = Math.hypot(...sub(from, scene.centre));
    if (away > far && long > far) return [add(from, d, Math.max(0, 1 - far / long)), to];
    return long > 3 * far ? [from, add(from, d, 3 * far / long)] : [from, to];
  };

  const strokes = () => {
    const path = new Set(pathTo(walk.ray)), lines = [];
    const sure = scene.radius * 0.03;
    rays.forEach((_, ray) => {
      if (tree.isHidden(ray)) return;
      const kind = start(ray).kind, past = startOf(ray) <= walk.moment, on = path.has(ray), current = ray === walk.ray;
      const [from, to] = shortened([start(ray).origin, endOfRay(ray)]);
      const colour = [...ink[kind], current ? 1 : on ? 0.95 : past ? 0.75 : 0.22];
      lines.push({ from, to, colour, width: current ? 5 : on ? 3.6 : past ? 2.2 : 1.4, dashed: kind === 'shadow' });
      if (!past && !on) return;
      const d = sub(to, from), long = Math.hypot(...d), along = unit(d), tip = add(from, d, 0.55);
      const aside = unit(cross(along, back())), size = Math.min(sure * (current ? 2 : 1.4), long * 0.2);
      for (const side of [1, -1])
        lines.push({ from: tip, to: add(add(tip, along, -size), aside, side * size * 0.5), colour, width: current ? 4 : 2.4 });
    });
    const hit = find(walk.ray, 'boundary_chosen');
    if (hit) {
      const tip = add(hit.point, hit.facing, scene.radius * 0.22);
      lines.push({ from: hit.point, to: tip, colour: [0, 0.5, 0.35, 1], width: 3 });
    }
    for (const event of rays[walk.ray].events)
      if (event.event === 'place_entered' && ['cell', 'extent', 'part'].includes(event.kind)) {
        const corner = i => [0, 1, 2].map(axis => number((i >> axis) & 1 ? event.high[axis] : event.low[axis]));
        for (let i = 0; i < 8; ++i)
          for (const axis of [1, 2, 4])
            if (!(i & axis) && corner(i | axis).every(Number.isFinite)) lines.push({ from: corner(i), to: corner(i | axis), colour: [0.35, 0.3, 0.55, 0.6], width: 1.3 });
      }
    return lines;
  };

  // The direction from which the rays spread widest, a little from above.
  const fit = () => {
    let best = -1;
    for (let step = 0; step < 36; ++step)
      for (const elevation of [0.25, 0.45]) {
        const azimuth = step * Math.PI / 18, e = { ...camera };
        Object.assign(camera, { azimuth, elevation });
        const line = back();
        let seen = 0, all = 0;
        rays.forEach((_, ray) => {
          if (start(ray).kind === 'shadow') return;
          const [from, to] = shortened([start(ray).origin, endOfRay(ray)]), d = sub(to, from), w = weight(ray) ** 0.35;
          seen += w * Math.sqrt(Math.max(0, dot(d, d) - dot(d, line) ** 2));
          all += w * Math.hypot(...d);
        });
        Object.assign(camera, e);
        const right = cross(up, line), score = (all > 0 ? seen / all : 0) + (dot(start(0).direction, right) > 0 ? 0.05 : 0);
        if (score > best) { best = score; Object.assign(camera, { bestAzimuth: azimuth, bestElevation: elevation }); }
      }
    Object.assign(camera, { azimuth: camera.bestAzimuth, elevation: camera.bestElevation, centre: scene.centre, distance: 3.1 * scene.radius });
  };
  const lookFrom = (direction, centre, distance) => {
    const d = unit(direction);
    camera.elevation = Math.asin(Math.max(-0.999, Math.min(0.999, dot(d, up))));
    camera.azimuth = Math.atan2(dot(d, north), dot(d, east));
    Object.assign(camera, { centre, distance });
  };
  const cameras = {
    fit,
    eye: () => { const to = endOfRay(0), d = sub(trace.eye, to); lookFrom(d, to, Math.max(Math.hypot(...d), scene.radius * 0.1)); },
    along: () => { const from = start(walk.ray).origin, to = endOfRay(walk.ray), d = add(sub(from, to), up, scene.radius * 0.15); lookFrom(d, to, Math.min(Math.max(Math.hypot(...d), scene.radius * 0.5), 6 * scene.radius)); },
  };

  if (!gl) {
    canvas.hidden = true;
    element('unseen').hidden = false;
    element('unseen').textContent = 'This browser shows no WebGL 2. The tree, the intervals, the card and all numbers work without it.';
    for (const id of ['cameras', 'objects']) element(id).hidden = true;
    return { show() {}, camera, cameras, changed() {}, canvas };
  }

  const program = ({ vertex, fragment }) => {
    const made = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    return { made, at: name => gl.getUniformLocation(made, name), input: name => gl.getAttribLocation(made, name) };
  };
  const forMeshes = program(meshShader), forLines = program(lineShader);
  const feed = (to, name, size, stride, offset) => {
    const input = to.input(name);
    gl.enableVertexAttribArray(input);
    gl.vertexAttribPointer(input, size, gl.FLOAT, false, stride * 4, offset * 4);
  };
  const meshes = scene.surfaces.map(meshOf);
  for (const mesh of meshes) {
    mesh.array = gl.createVertexArray();
    gl.bindVertexArray(mesh.array);
    for (const [name, data] of [['place', mesh.places], ['normal', mesh.normals]]) {
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
      feed(forMeshes, name, 3, 3, 0);
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.triangles, gl.STATIC_DRAW);
  }
  const lineArray = gl.createVertexArray(), lineBuffer = gl.createBuffer();
  gl.bindVertexArray(lineArray);
  gl.bindBuffer(gl.ARRAY_BUFFER, lineBuffer);
  feed(forLines, 'from', 3, 14, 0);
  feed(forLines, 'to', 3, 14, 3);
  feed(forLines, 'colour', 4, 14, 6);
  feed(forLines, 'place', 4, 14, 10);

  const matrix = () => {
    const eye = eyePoint(), z = back(), x = unit(cross(up, z)), y = cross(z, x), f = 1 / Math.tan(0.35);
    const aspect = canvas.width / canvas.height, far = camera.distance + 40 * scene.radius, near = Math.max(camera.distance / 200, far / 20000);
    const a = -(far + near) / (far - near), b = -2 * far * near / (far - near);
    const sx = f / Math.max(aspect, 0.6) * (aspect < 0.6 ? 0.6 / aspect : 1), sy = sx * aspect;
    const columns = [];
    for (const axis of [0, 1, 2]) columns.push(sx * x[axis], sy * y[axis], a * z[axis], -z[axis]);
    columns.push(-sx * dot(x, eye), -sy * dot(y, eye), -a * dot(z, eye) + b, dot(z, eye));
    return new Float32Array(columns);
  };

  const opacity = { solid: 1, half: 0.55, clear: 0.24, ghost: 0.1 };
  const drawMesh = (mesh, opaque) => {
    const { surface } = mesh;
    gl.uniform3fv(forMeshes.at('tint'), surface.colour);
    gl.uniform1f(forMeshes.at('opaque'), opaque);
    gl.uniform1f(forMeshes.at('squares'), surface.squares ? 1 : 0);
    if (surface.squares)
      for (const [i, name] of ['u', 'v'].entries()) gl.uniform3fv(forMeshes.at(name), surface.squares[i].map(c => c / dot(surface.squares[i], surface.squares[i])));
    gl.bindVertexArray(mesh.array);
    gl.drawElements(gl.TRIANGLES, mesh.triangles.length, surface.wide ? gl.UNSIGNED_INT : gl.UNSIGNED_SHORT, 0);
  };

  let drawn = 0;
  const paint = () => {
    drawn = 0;
    const scale = Math.min(devicePixelRatio || 1, 2), width = Math.round(canvas.clientWidth * scale), height = Math.round(canvas.clientHeight * scale);
    if (width === 0 || height === 0) return;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    gl.clearColor(0.965, 0.975, 0.985, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const eye = eyePoint(), all = matrix();
    gl.useProgram(forMeshes.made);
    gl.uniformMatrix4fv(forMeshes.at('matrix'), false, all);
    gl.uniform3fv(forMeshes.at('eye'), eye);
    // A wall that stands between the eye and the room is seen through.
    const lookOf = mesh => mesh.look === 'solid' && mesh.surface.squares && dot(mesh.facing, sub(eye, mesh.middle)) < 0 ? 'ghost' : mesh.look;
    for (const mesh of meshes) if (lookOf(mesh) === 'solid') drawMesh(mesh, 1);
    gl.useProgram(forLines.made);
    gl.uniformMatrix4fv(forLines.at('matrix'), false, all);
    gl.uniform2f(forLines.at('pixels'), canvas.width / scale, canvas.height / scale);
    gl.uniform1f(forLines.at('dash'), scene.radius * 0.09);
    const data = lineVertices(strokes());
    gl.bindVertexArray(lineArray);
    gl.bindBuffer(gl.ARRAY_BUFFER, lineBuffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    gl.drawArrays(gl.TRIANGLES, 0, data.length / 14);
    // What one sees through comes last, from the back, its far side first.
    gl.useProgram(forMeshes.made);
    gl.depthMask(false);
    gl.enable(gl.CULL_FACE);
    const clear = meshes.filter(mesh => !['solid', 'hidden'].includes(lookOf(mesh)));
    clear.sort((a, b) => Math.hypot(...sub(b.middle, eye)) - Math.hypot(...sub(a.middle, eye)));
    for (const mesh of clear)
      for (const side of [gl.FRONT, gl.BACK]) { gl.cullFace(side); drawMesh(mesh, opacity[lookOf(mesh)]); }
    gl.disable(gl.CULL_FACE);
    gl.depthMask(true);
  };
  const changed = () => { if (drawn === 0) drawn = requestAnimationFrame(paint); };

  element('objects').querySelector('ul').append(...meshes.map(mesh => {
    const choice = make('select', { 'aria-label': 'how to show ' + mesh.surface.name }, ...['solid', 'half', 'clear', 'ghost', 'hidden'].map(look => make('option', {}, look)));
    choice.value = mesh.look;
    choice.addEventListener('change', () => { mesh.look = choice.value; changed(); });
    return make('li', {}, make('span', {}, mesh.surface.name), choice);
  }));
  if (scene.left_out > 0) element('objects').append(make('p', {}, `${scene.left_out} more objects are not drawn`));
  fit();
  addEventListener('resize', changed);
  addEventListener('beforeprint', paint);
  return { show: changed, camera, cameras, changed, canvas, back, up, paint };
})();
