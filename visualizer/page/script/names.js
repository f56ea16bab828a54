// What a person calls things.
const objectName = id => id < 0 ? 'nothing' : trace.objects[id].name;
const leafName = id => id < 0 ? 'nothing' : trace.generics[id];
const mediumName = id => id < 0 ? 'unknown' : trace.media[id].name;
const lightName = id => id < 0 ? '' : trace.lights[id].name || '#' + id;

const blockerOf = ray => rays[ray].events.findLast(event => event.event === 'object_accepted');

const becameOf = ray => {
  const kind = start(ray).kind, end = find(ray, 'ray_finished');
  if (kind === 'shadow') {
    const light = 'to ' + lightName(start(ray).light) + ': ';
    if (!end) return light + '?';
    if (end.colour.every(c => c === 1)) return light + 'free';
    if (end.colour.every(c => c === 0)) { const blocker = blockerOf(ray); return '✗ ' + light + 'blocked by ' + (blocker ? objectName(blocker.object) : '?'); }
    return light + 'dimmed to ' + shownColour(end.colour);
  }
  if (find(ray, 'missed')) return '→ background';
  const hit = find(ray, 'boundary_chosen');
  if (!hit) return '→ ?';
  if (find(ray, 'totally_reflected')) return '↯ total at ' + objectName(hit.object);
  return (!find(ray, 'refracted') ? '→ ' : hit.entering ? '→ into ' : '→ out of ') + objectName(hit.object);
};

// Of a ray or a boundary behind which each colour goes its own way.
const line = event => event.wavelength > 0 ? `, ${shown(event.wavelength)} nm` : '';

const eventText = event => {
  switch (event.event) {
    case 'ray_spawned': return `starts, ${event.kind}, depth ${event.depth}`;
    case 'search_began': return `${event.stage} looks among ${event.objects} objects`;
    case 'place_entered': return `${event.kind} ${event.object >= 0 ? 'of ' + objectName(event.object) : event.place}`;
    case 'place_left': return `${event.tested} tests, ${event.spared} spared`;
    case 'search_ended': return `search ends: ${event.tested} tests, ${event.spared} saved`;
    case 'object_accepted': return `${objectName(event.object)} counts, t = ${shown(event.t)}`;
    case 'node_evaluated': return `${nodeName(event)}: inside ${event.count === 0 ? 'never' : event.count === 1 ? 'once' : event.count + ' times'}`;
    case 'span_found': return `inside ${shown(event.enter.t)} < t < ${shown(event.exit.t)}`;
    case 'cluster_merged': return `${event.count} crossings as one: ${event.kept ? 'one stays' : 'all vanish'}`;
    case 'boundary_chosen': return `hit: ${event.entering ? 'into' : 'out of'} ${objectName(event.object)}, t = ${shown(event.boundary.t)}`;
    case 'triangle_hit': return `triangle ${event.triangle}`;
    case 'missed': return `nothing is hit: background ${shownColour(event.background)}`;
    case 'absorbed': return `the medium leaves ${shownColour(event.passed)} on ${shown(event.length)} of way`;
    case 'fresnel_shared': return `Fresnel: R = ${shown(event.reflected)}${line(event)}`;
    case 'ambient_lit': return `ambient ${shownColour(event.scene)} × ${shownColour(event.material)}`;
    case 'light_lit': return `${lightName(event.light)}: ${number(event.cosine) > 0 ? 'diffuse ' + shownColour(event.diffuse) + ', specular ' + shownColour(event.specular) : 'behind the surface'}`;
    case 'local_light_skipped': return 'no local light: leaves a solid';
    case 'blocker_passed': return `light passes ${objectName(event.object)} × ${shownColour(event.transmission)}`;
    case 'reflected': return `mirrored, θ = ${degrees(event.theta)}`;
    case 'refracted': return `bent, θ₁ = ${degrees(event.theta_from)}, θ₂ = ${degrees(event.theta_to)}${line(event)}`;
    case 'totally_reflected': return `total reflection, θ₁ = ${degrees(event.theta_from)} > ${degrees(event.critical)}`;
    case 'not_spawned': return `no ${event.kind} ray: ${event.reason.replaceAll('_', ' ')}`;
    case 'ray_finished': return `ends with ${shownColour(event.colour)}`;
    case 'truncated': return 'the record was full';
  }
  return event.event;
};

const nodeName = event => {
  const object = trace.objects[event.object];
  return event.node + 1 === object.nodes.length ? object.name : object.nodes[event.node].name;
};
