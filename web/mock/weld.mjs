// A canned weld for the mock: the saddle of a nozzle on a shell, and the machine of SADDLE-2020 in outline.

const R = 250;
const SHELL = 800;
const POINTS = 361;
const SPEED = 10;

const eye = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
const at = (x, y, z) => [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z];

function turn(deg) {
  const c = Math.cos((deg * Math.PI) / 180);
  const s = Math.sin((deg * Math.PI) / 180);
  return [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0];
}

function point(deg) {
  const phi = (deg * Math.PI) / 180;
  const [x, y] = [R * Math.cos(phi), R * Math.sin(phi)];
  const z = Math.sqrt(SHELL * SHELL - y * y) - SHELL;
  const beta = -45 + 8 * Math.cos(2 * phi);
  const b = (beta * Math.PI) / 180;
  const out = -Math.sin(b);
  return { tip: [x, y, z], torch: [Math.cos(phi) * out, Math.sin(phi) * out, Math.cos(b)], axes: [deg, R - 400 - 100 * Math.sin(b), z - 100 + 100 * Math.cos(b), beta] };
}

function pass(role, speed) {
  const path = [];
  let s = 0;
  for (let i = 0; i < POINTS; i += 1) {
    const p = point(20 + i);
    if (i > 0) s += Math.hypot(...p.tip.map((v, k) => v - path[i - 1].tip[k]));
    const edge = Math.min(1, i / 4, (POINTS - 1 - i) / 4);
    path.push({ ...p, s_mm: s, speed_mm_s: speed * edge, values: [240 - 20 * Math.cos((i / 180) * Math.PI * 2), 27, 8], used: p.axes.map((_, k) => [30 + 5 * k, 20, 100 * (1 - edge)].map(Math.round)), clearance_mm: 8 + 4 * Math.cos((i / 90) * Math.PI) });
  }
  const tip = path[90].tip;
  const nearest = { distance_mm: 4, least_mm: 1, between: ['gas nozzle', 'shell'], at: [[tip[0], tip[1], tip[2] + 12], [tip[0], tip[1], tip[2] + 8]] };
  const bound = (from_mm, to_mm, what, axis) => ({ from_mm, to_mm, least_speed_mm_s: speed * (axis ? 0 : 1), between: !axis, what, axis, limit: axis ? 100 : null, unit: axis ? 'mm/s^3' : null });
  const certificate = {
    at_asked_percent: 98,
    everywhere_mm_s: 14,
    bounds: [bound(0, 8, 'jerk', 's'), bound(8, s - 8, 'asked', null), bound(s - 8, s, 'jerk', 's')],
    uses: ['theta', 's', 'h', 'beta'].map((name, k) => ({ axis: name, unit: k % 3 === 0 ? 'deg' : 'mm', percent: [30 + 5 * k, 20, 98], limit: [50, 100, 1000] })),
  };
  return { certificate, spans: [[0, s]], points_mm: [], nearest, nearest_at_mm: path[90].s_mm, name: role, role, length_mm: s, time_s: s / speed + 4, speed_mm_s: speed, closed: true, path };
}

/** A V of 60 degrees in 12 mm with two beads. */
function section(s_mm) {
  const side = (x) => [[x * 1.5, -12], [x * 1.5, -10], [x * 7.3, 0]];
  const plate = (x) => [...side(x), [x * 22, 0], [x * 22, -12]];
  const bead = (role, area_mm2, low, high) => ({ name: role, role, area_mm2, tip: [0, low], back: [0, 1], outline: [[-1.5 - Math.max(0, low + 10) * 0.577, low], [1.5 + Math.max(0, low + 10) * 0.577, low], [1.5 + (high + 10) * 0.577, high], [-1.5 - (high + 10) * 0.577, high]] });
  return { s_mm, dihedral_deg: 180, root_gap_mm: 3, mismatch_mm: 0, area_mm2: 93.7, cap_mm2: 12, parts: [plate(1), plate(-1)], edges: [side(1), side(-1)], beads: [bead('root', 30, -12, -7), bead('cap', 75, -7, 0)] };
}

export function work(id, job, from) {
  const passes = [pass('root', SPEED), pass('cap', 8)];
  const tips = passes[0].path[0].tip;
  return {
    id,
    machine: 'saddle-4axis',
    axes: machine.axes,
    job,
    title: 'Saddle: nozzle 500 mm diameter on shell 1600 mm diameter',
    values: ['current_a', 'voltage_v', 'wire_feed_m_min'],
    passes,
    air: [[[400, 0, 120], [tips[0], tips[1], 60], tips], [tips, [tips[0], tips[1], 60], tips], [tips, [400, 0, 120]]],
    part: [
      { name: 'nozzle', shape: { kind: 'cone', radius: R, top_radius: R, length: 300 }, frame: at(0, 0, -120), link: 0 },
      { name: 'shell', shape: { kind: 'cone', radius: SHELL, top_radius: SHELL, length: 1200 }, frame: [0, 0, 1, -600, 0, 1, 0, 0, -1, 0, 0, -SHELL], link: 0 },
    ],
    fixtures: [],
    sections: [section(0), section(400)],
    findings: [
      { kind: 'speed', message: 'the tip is 0.8 % below the asked speed: 9.92 mm/s of 10 mm/s', pass: 1, from_mm: 400, to_mm: 410, cure: 'ask for a lower speed there', allowed: true, axes: [], nearest: null },
    ],
    good: true,
    time_s: passes.reduce((sum, p) => sum + p.time_s, 0) + 20,
    from,
  };
}

const axis = (name, unit, from, to, home, max_speed) => ({ name, unit, range: [from, to], home, max_speed });
const solid = (name, link, shape, frame) => ({ name, link, shape, frame });

export const machine = {
  name: 'saddle-4axis',
  title: '4-axis saddle welder (SADDLE-2020)',
  simulated: true,
  period_s: 0.001,
  axes: [axis('theta', 'deg', -400, 400, 0, 30), axis('s', 'mm', -200, 200, 0, 50), axis('h', 'mm', -150, 150, 120, 50), axis('beta', 'deg', -80, 80, 0, 20)],
  conditions: [{ name: 'door', level: 'motion' }, { name: 'gas pressure', level: 'process' }],
  solids: [
    solid('spindle', 0, { kind: 'cone', radius: 50, top_radius: 50, length: 400 }, at(0, 0, -50)),
    solid('beam', 1, { kind: 'box', size: [700, 160, 100] }, at(150, 0, 400)),
    solid('carriage', 2, { kind: 'box', size: [120, 160, 60] }, at(400, 0, 390)),
    solid('ram', 3, { kind: 'box', size: [60, 60, 400] }, at(400, 130, 320)),
    solid('gas nozzle', 4, { kind: 'cone', radius: 8, top_radius: 12, length: 45 }, at(400, 0, 15)),
    solid('torch body', 4, { kind: 'cone', radius: 14, top_radius: 14, length: 80 }, at(400, 0, 60)),
  ],
  zones: [{ name: 'door', permitted: false, solids: [solid('door', 0, { kind: 'box', size: [200, 900, 500] }, at(-800, 0, 100))] }],
  frames: [{ name: 'base', link: 0, frame: eye }, { name: 'work', link: 0, frame: eye }, { name: 'torch', link: 4, frame: at(400, 0, 0) }],
  base: 0,
  torch: 4,
  up: [0, 0, 1],
  jog_mm_s: 250,
  joints: [
    null,
    { on: 0, axis: 0, direction: [0, 0, 1], at: [0, 0, 0] },
    { on: 1, axis: 1, direction: [1, 0, 0], at: [0, 0, 0] },
    { on: 2, axis: 2, direction: [0, 0, 1], at: [0, 0, 0] },
    { on: 3, axis: 3, direction: [0, -1, 0], at: [400, 0, 100] },
  ],
  sensors: [
    { name: 'camera', kind: 'camera', link: 4, field: [[430, 28, 0], [430, 92, 0], [370, 92, 0], [370, 28, 0]] },
    { name: 'stripe', kind: 'stripe', link: 4, field: [[380, 25, -15], [420, 25, -15], [420, 25, 15], [380, 25, 15]] },
  ],
  beam: false,
  beam_mm: null,
};

/** How the links have moved, and the tip, at positions of the axes. */
export function pose([theta, s, h, beta]) {
  const spin = turn(theta);
  const moved = (x, z) => [spin[0], spin[1], 0, spin[0] * x, spin[4], spin[5], 0, spin[4] * x, 0, 0, 1, z];
  const b = (beta * Math.PI) / 180;
  const [c, sn] = [Math.cos(b), Math.sin(b)];
  // About -y through (400 + s, 0, 100 + h), where the swing axis is.
  const swing = [c, 0, -sn, 400 - 400 * c + 100 * sn + s, 0, 1, 0, 0, sn, 0, c, 100 - 400 * sn - 100 * c + h];
  const torch = [];
  for (let r = 0; r < 3; r += 1) {
    for (let k = 0; k < 4; k += 1) torch.push(spin[r * 4] * swing[k] + spin[r * 4 + 1] * swing[4 + k] + spin[r * 4 + 2] * swing[8 + k] + (k === 3 ? spin[r * 4 + 3] : 0));
  }
  const rho = 400 + s + 100 * sn;
  const tip = [spin[0] * rho, spin[4] * rho, 100 + h - 100 * c, -spin[0] * sn, -spin[4] * sn, c];
  return { links: [eye, moved(0, 0), moved(s, 0), moved(s, h), torch], tip };
}
