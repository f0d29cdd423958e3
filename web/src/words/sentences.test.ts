import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { read } from '../jobs/toml';
import { ofAnswers, ofFiles, ofJobs, ofWelds, rows, sentence, shipped } from './sentences';

/** All strings of crates, with holes for whatever stands in them; a line that ends in a backslash goes on. */
const sources = (crates: string[]): string => crates.flatMap((crate) => {
  const folder = new URL(`../../../crates/${crate}/src/`, import.meta.url);
  return readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.rs')).map((name) => readFileSync(new URL(name, folder), 'utf8'));
}).join('\n').replace(/\\\n\s*/g, '').replace(/\\"/g, '"').replace(/\{[^{}"\n]*\}/g, '{}');

const bare = (text: string): string => text.replace(/\{[^{}"]*\}/g, '{}');
const holes = (text: string): string => [...new Set(text.match(/\{\d\}/g))].sort().join();

describe('sentences of plans', () => {
  test('are those of the cell', () => {
    const pieces = rows.flatMap(([en]) => en.split('|')).map((piece) => bare(piece).replace(/^; /, '').trim()).filter((piece) => piece !== '{}' && piece !== '{} to {}');
    expect(pieces.length).toBeGreaterThan(80);
    const texts = sources(['motion', 'weld', 'program', 'machine', 'cell', 'tracking', 'project']);
    // The code puts the name of a body and whose it is together from two arguments.
    const whose = (piece: string): string => piece.replace(/^\{\} \((part|fixtures)\)$/, '{} ({})');
    expect(pieces.filter((piece) => !texts.includes(whose(piece)))).toEqual([]);
  });

  test('of welds are those of the cell', () => {
    const texts = sources(['cell', 'project', 'record', 'server', 'cli', 'tracking']);
    expect(ofWelds.map(([en]) => bare(en)).filter((piece) => !texts.includes(piece))).toEqual([]);
  });

  test('of jobs are those of the cell', () => {
    const texts = sources(['document', 'program', 'weld', 'project', 'geometry']);
    // What the TOML reader says itself, and what stands in a longer text of ours.
    const mine = ['invalid value: {}', 'invalid type: {}', 'a table'];
    // Others stand within a text: `copies[2] has this name already`, `it is none, expected one`.
    const within = (piece: string): boolean => texts.includes(`"${piece}"`) || texts.includes(`${piece}, expected `) || texts.includes(`, expected ${piece}"`) || (piece.startsWith('{} ') && texts.includes(`${piece.slice(2)}"`));
    // What is only numbers but for its words is written in many ways.
    const pieces = ofJobs.map(([en]) => en).filter((piece) => !piece.includes('#}') || (!piece.startsWith('more than') && piece.replace(/\{.*?\}/g, '').trim().split(' ').length > 3));
    expect(pieces.length).toBeGreaterThan(280);
    expect(pieces.map(bare).filter((piece) => !mine.includes(piece) && !within(piece))).toEqual([]);
  });

  test('comments and titles of the files that ship are all there, and no others', () => {
    const files = (folder: string): string[] => {
      const at = new URL(`../../../${folder}/`, import.meta.url);
      return readdirSync(at).filter((name) => name.endsWith('.toml')).map((name) => readFileSync(new URL(name, at), 'utf8'));
    };
    const comments = [...files('examples'), ...files('examples/procedures')].flatMap((text) => read(text).map((entry) => entry.comment));
    const titles = [...files('machines'), ...files('examples/procedures')].map((text) => /^title = "(.*)"$/m.exec(text)?.[1] ?? '');
    const shipped = new Set([...comments, ...titles].filter((text) => text !== ''));
    const known = ofFiles.map(([en]) => en);
    expect([...shipped].filter((text) => !known.includes(text))).toEqual([]);
    expect(known.filter((text) => !shipped.has(text))).toEqual([]);
    expect(new Set(known).size).toBe(known.length);
  });

  test('of answers are those of the cell', () => {
    const texts = sources(['server', 'project', 'post', 'record', 'program', 'geometry', 'machine', 'document']);
    // How an answer is put together, and what only names or numbers go into.
    const pieces = ofAnswers.flatMap(([en]) => en.split('|')).filter((en) => !/^(\{\d\}[;:] )?(allowed|cure): \{\d\}$/.test(en) && (!/#\}/.test(en) || en.replace(/\{.*?\}/g, '').trim().split(' ').length > 3));
    expect(pieces.length).toBeGreaterThan(180);
    const words = (text: string): string => bare(text).replace(/\n/g, '\\n').replace(/; allowed: .*$/, '');
    expect(pieces.filter((piece) => !words(piece).split('{}').every((part) => texts.includes(part.trim())))).toEqual([]);
  });

  test('every refusal of the panel\'s server has words', () => {
    const folder = new URL('../../../crates/server/src/', import.meta.url);
    const files = ['edit', 'hand', 'jobs', 'place', 'plan', 'restore', 'sensors', 'setup', 'socket', 'teach', 'turns', 'users'].map((name) => `http/${name}.rs`);
    const own = ['planner/mod.rs', 'planner/child.rs', 'planner/question.rs', 'front/mod.rs', 'front/bodies.rs', 'teaching/cameras.rs'];
    const texts = [...files, ...own, 'teaching/crawl.rs', 'teaching/mod.rs', 'teaching/state.rs', 'teaching/rig.rs', 'users/accounts.rs', 'cell/desk.rs']
      .map((file) => readFileSync(new URL(file, folder), 'utf8').replace(/\\\n\s*/g, '').replace(/\\"/g, '\u0001'));
    const refusals = /(?:Refused::(?:input|not_found|server)|Err|Trouble::new|refuse|lack|let text =|let why =)\(?(?:"busy", |"moving", |"work", |"mode", )?(?:format!\(\s*)?\s*"([^"]{12,})"/g;
    const said = texts.flatMap((text) => [...text.matchAll(refusals)].map((m) => m[1] ?? ''));
    expect(said.length).toBeGreaterThan(40);
    // What no page of ours asks for, and what passes on what others said.
    const foreign = /^(there is no (axis|dialect|column|parameter|language|head|sensor|`)|`7`? (has|is)|most=|probe_radius_mm|tip_mm|pitch_mm|point 7: feature|a touch is|a job without a picture)/;
    const filled = said.map((text) => text.replaceAll('\u0001', '"').replace(/\{[^{}]*\}/g, '7')).flatMap((text) => (foreign.test(text) ? [] : text.split(/: allowed: |; allowed: |\\n {3}allowed: /)));
    const asked = filled.filter((text) => / \p{L}/u.test(text) && !foreign.test(text));
    expect(asked.filter((text) => sentence(text, 'de') === text)).toEqual([]);
    // And all of it: no English is left but names and keys.
    const english = /\b(the|is|are|allowed|not|must|cannot|there|has|of|to)\b/;
    expect(asked.map((text) => sentence(text, 'de').replace(/`[^`]*`/g, '')).filter((text) => english.test(text))).toEqual([]);
  });

  test('of answers are put together', () => {
    expect(sentence('there are too many jobs; allowed: 1000', 'de')).toBe('es sind zu viele Aufträge; erlaubt: 1000');
    expect(sentence('short.toml: cannot be removed: Permission denied (os error 13)', 'de')).toBe('short.toml: lässt sich nicht löschen: Permission denied (os error 13)');
    expect(sentence('step 4 of pass "root": an arc of more than a turn\n   cure: make it several', 'de')).toBe('Schritt 4 von Lage „root“: ein Bogen von mehr als einer Umdrehung\n   Abhilfe: mehrere daraus machen');
    expect(sentence('too few points of the plane: 2, and at least 3 are needed; allowed: more points, spread over what they should tell, or another method', 'uk'))
      .toBe('замало точок (площина): 2, а треба щонайменше 3; дозволено: більше точок, розподілених по тому, що вони мають показати, або інший спосіб');
    expect(sentence('not seen: turning about the axis along (0, 0, 1) through (0, 0, 0) mm; left as it was', 'ru')).toBe('не видно: поворот вокруг оси вдоль (0, 0, 1) через (0, 0, 0) мм; оставлено как было');
    expect(sentence('proven by reading back: 7 moves, rounding 1.0e-5; greatest deviations:', 'de')).toBe('durch Zurücklesen nachgewiesen: 7 Bewegungen, Rundung 1.0e-5; größte Abweichungen:');
  });

  test('of several lines are said line by line', () => {
    expect(sentence('pass 1 (root): the tip leaves the planned path by 0.3 mm; 0.1 mm are allowed\npass 2 (cap): its time is 3.200 % off the planned one; 0.1 % are allowed\npass 2 (cap): current_a is 3.20 % off the planned one; 1 % are allowed', 'de'))
      .toBe('Lage 1 (root): die Spitze verlässt die geplante Bahn um 0.3 mm; erlaubt sind 0.1 mm\nLage 2 (cap): seine Zeit weicht um 3.200 % von der geplanten ab; erlaubt sind 0.1 %\nLage 2 (cap): current_a weicht um 3.20 % vom Geplanten ab; erlaubt sind 1 %');
    const findings = 'the weld cannot be made as asked: 1 finding\nfinding (slow): axis theta cannot keep 10.000 mm/s: its acceleration limit of 20.000 deg/s^2 allows 9.412 mm/s\n   where: pass 1, s = 3.000 to 8.500 mm\n   cure: ask for less speed there';
    expect(sentence(findings, 'de')).toBe('die Schweißung ist so nicht möglich: 1 Befund\nBefund (slow): Achse theta kann 10.000 mm/s nicht halten: ihre Grenze für Beschleunigung von 20.000 deg/s^2 erlaubt 9.412 mm/s\n   wo: Lage 1, s = 3.000 to 8.500 mm\n   Abhilfe: ' + sentence('ask for less speed there', 'de'));
  });

  test('of files that ship are found whole; what users write stays as it is', () => {
    expect(shipped('a beam is thin', 'de')).toBe('ein Strahl ist dünn');
    for (const text of ['axis offset', 'axis of the tube', '12 to 15', 'round', 'Welder (head 2)', 'drive fault']) expect(shipped(text, 'de')).toBe(text);
  });

  test('have the same holes in every language', () => {
    for (const row of [...rows, ...ofJobs, ...ofAnswers]) for (const text of row) expect(holes(text), text).toBe(holes(row[0]));
    for (const [en, ...others] of [...rows, ...ofJobs, ...ofAnswers]) for (const text of others) expect(text.length, en).toBeGreaterThan(0);
  });

  test('every finding and cure of the cell that is a sentence of its own has words', () => {
    const motion = ['pass_motion', 'corners', 'survey', 'limits', 'singular', 'arc_limits', 'pass_clearance', 'weld_motion', 'redundancy/explain', 'procedure/findings'];
    const files = [...motion.map((file) => `motion/src/${file}`), 'weld/src/pass_findings', 'weld/src/beads/plan', 'cell/src/summary'];
    const texts = files.map((file) => readFileSync(new URL(`../../../crates/${file}.rs`, import.meta.url), 'utf8').replace(/\\\n\s*/g, '').replace(/\\"/g, '\u0001'));
    const said = texts.flatMap((text) => [...text.matchAll(/(?:message: |cure: |let message = |let cure = |=> )(?:format!\(\s*)?"([^"]{12,})"/g)].map((m) => m[1] ?? ''));
    expect(said.length).toBeGreaterThan(30);
    // Numbers stand where the holes are.
    const filled = said.map((text) => text.replaceAll('\u0001', '"').replace(/\{[^{}]*\}/g, '7'));
    // Parts of sentences, and what names keys of files only.
    const mine = ['set corner = "stop" to stop there with the arc on; or weave', 'the 7 is 7', '7 is 7'];
    const words = (text: string): boolean => /\p{L}{3}/u.test(text);
    expect(filled.filter((text) => words(text) && !mine.some((start) => text.startsWith(start)) && sentence(text, 'de') === text)).toEqual([]);
  });

  test('are found again with what stands in them, also one in another', () => {
    const slow = 'axis theta cannot keep 10.000 mm/s: its acceleration limit of 20.000 deg/s^2 allows 9.412 mm/s';
    expect(sentence(slow, 'de')).toBe('Achse theta kann 10.000 mm/s nicht halten: ihre Grenze für Beschleunigung von 20.000 deg/s^2 erlaubt 9.412 mm/s');
    expect(sentence('the air move from pass 1 to pass 2: wire guide collides with shell (part) (at least 5 mm)', 'de')).toBe('der Luftweg von Lage 1 zu Lage 2: wire guide stößt gegen shell (Werkstück) (mindestens 5 mm)');
    expect(sentence('the heat input is 1.9 kJ/mm at s = 3.000 mm; WPS-1 allows (fill) 0.8 to 1.1', 'de')).toBe('Wärmeeinbringung ist 1.9 kJ/mm bei s = 3.000 mm; WPS-1 erlaubt (fill) 0.8 bis 1.1');
    expect(sentence('ask for less speed there; or use a procedure that is qualified for it', 'uk')).toBe('задайте там меншу швидкість; або візьміть технологію, яка це дозволяє');
    expect(sentence('saddle: the axes cannot reach the point; it is 3.0000 mm off', 'zh')).toBe('saddle: 各轴到不了该点：差 3.0000 mm');
    expect(sentence('invalid value: -3', 'de')).toBe('unzulässiger Wert: -3');
    expect(sentence('more than 0 and less than radius_mm = 800', 'de')).toBe('mehr als 0 und weniger als radius_mm = 800');
    expect(sentence('0 to 1e-7', 'de')).toBe('0 bis 1e-7');
    expect(sentence('more than 0, up to 1', 'de')).toBe('mehr als 0, bis 1');
    // What only looks like a range is none.
    for (const text of ['a gap or an angle that leaves room to weld', 'less than the way from a tack to the next', 'perpendicular to end - start', 'tube to head']) expect(sentence(text, 'de')).toBe(text);
    expect(sentence(slow, 'en')).toBe(slow);
    expect(sentence('what nobody has said', 'ru')).toBe('what nobody has said');
  });
});
