// Turning, moving and coming closer, with a mouse or with fingers.
(() => {
  const { canvas, camera } = view, fingers = new Map();
  const turn = (dx, dy) => {
    camera.azimuth -= dx * 0.008;
    camera.elevation = Math.max(-1.5, Math.min(1.5, camera.elevation + dy * 0.008));
  };
  const move = (dx, dy) => {
    const z = view.back(), size = camera.distance * 0.73 / canvas.clientWidth;
    const x = [view.up[1] * z[2] - view.up[2] * z[1], view.up[2] * z[0] - view.up[0] * z[2], view.up[0] * z[1] - view.up[1] * z[0]];
    const long = Math.hypot(...x) || 1, y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
    camera.centre = camera.centre.map((c, i) => c - (x[i] * dx - y[i] * dy) / long * size);
  };
  const closer = factor => { camera.distance = Math.max(1e-6 * scene.radius, Math.min(1e4 * scene.radius, camera.distance * factor)); };
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return { size: Math.hypot(a.x - b.x, a.y - b.y), x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  };
  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  canvas.addEventListener('pointermove', event => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const was = fingers.size === 2 ? spread() : null;
    const dx = event.clientX - before.x, dy = event.clientY - before.y;
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (was) {
      const is = spread();
      if (is.size > 0) closer(was.size / is.size);
      move(is.x - was.x, is.y - was.y);
    } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) move(dx, dy);
    else turn(dx, dy);
    view.changed();
  });
  for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, event => fingers.delete(event.pointerId));
  canvas.addEventListener('contextmenu', event => event.preventDefault());
  canvas.addEventListener('wheel', event => { event.preventDefault(); closer(Math.exp(event.deltaY * 0.0012)); view.changed(); }, { passive: false });
})();
