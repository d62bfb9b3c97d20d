// Answers scenes beside the page, so that dragging never waits for a plan.
//
// The page sends {name, module, fields} once for each body, with the bytes of its WebAssembly and
// the names of what it returns, and then {name, ask, scene, free, settings, seed}. The answer is
// {ask, took, facts, layers} or {ask, error}.
//
// A body is a function that numba compiled: its arguments are the fields of `SceneArrays`, each
// array with its shape and strides, then settings and generator. See kinoedu/browser/scenes.py.

const instances = new Map(), fields = new Map();

onmessage = ({ data }) => {
  if (data.module) {
    const module = new WebAssembly.Module(data.module);
    const { exports } = new WebAssembly.Instance(module, { wasi_snapshot_preview1: NO_SYSTEM });
    exports._initialize?.();
    instances.set(data.name, exports);
    fields.set(data.name, data.fields);
    return;
  }
  try {
    const began = performance.now();
    const { facts, ...layers } = answer(instances.get(data.name), fields.get(data.name), data);
    const memory = Object.values(layers).map(({ numbers }) => numbers.buffer);
    const took = performance.now() - began;
    postMessage({ ask: data.ask, took, facts: [...facts.numbers], layers }, memory);
  } catch (error) {
    instances.delete(data.name);     // its memory may be in disorder
    postMessage({ ask: data.ask, name: data.name, error: String(error) });
  }
};

// The C library would ask a system for its arguments and for where to print; there is none.
const NO_SYSTEM = new Proxy({}, { get: () => () => 52 });

// The arrays of a scene, in the order of `SceneArrays`, each [numbers, shape].
function arraysOf(scene, free) {
  const rings = [scene.boundary ?? [], ...scene.polygons.map(({ rings: [outer] }) => outer)];
  const first = [0];
  for (const ring of rings) first.push(first.at(-1) + ring.length);
  const rows = (values, columns) => [Float64Array.from(values.flat()), [values.length, columns]];
  return [
    rows(rings.flat(), 2),
    [BigInt64Array.from(first, BigInt), [first.length]],
    rows(scene.discs.map(({ at, radius }) => [...at, radius]), 3),
    rows(scene.handles.map(({ at, radius }) => [...at, radius ?? 0]), 3),
    free,
    [Float64Array.from(scene.lo), [2]],
    [Float64Array.from(scene.hi), [2]],
  ];
}

// A setting is a number, or rows of numbers.
const rowsOf = (setting) => (Array.isArray(setting)
  ? [Float64Array.from(setting.flat()), [setting.length, setting[0]?.length ?? 0]] : setting);

// An array as a body takes it; a number as it is.
function argument(hold, body, value) {
  if (!Array.isArray(value)) return [value];
  const [numbers, shape] = value;
  const at = hold(Math.max(numbers.byteLength, 8));
  new Uint8Array(body.memory.buffer).set(new Uint8Array(numbers.buffer), at);
  const size = numbers.BYTES_PER_ELEMENT;
  const strides = shape.map((_, k) => size * shape.slice(k + 1).reduce((a, b) => a * b, 1));
  return [0, 0, BigInt(numbers.length), BigInt(size), at, ...[...shape, ...strides].map(BigInt)];
}

function answer(body, names, { name, scene, free, settings, seed }) {
  const held = [];                   // memory to give back
  const hold = (size) => { held.push(body.allocate(size)); return held.at(-1); };
  const given = [...arraysOf(scene, free ?? [new Uint8Array(0), [0, 0]]), ...settings.map(rowsOf)];
  const args = given.flatMap((value) => argument(hold, body, value));
  const generator = body.seeded(seed), draws = [body.draw64(), body.draw32(), body.draw_double()];
  held.push(generator);
  args.push(0, ...[generator, generator, ...draws, 0].map(BigInt), 0, 0);
  const result = hold(2048), failure = hold(8);
  try {
    const status = body[name](result, failure, ...args);
    if (status !== 0) throw new Error(`the body ended with status ${status}`);
    return read(body, result, names);
  } finally {
    held.forEach((memory) => body.release(memory));
  }
}

// The arrays of what is shown, at a place in memory: facts in a row, all others in rows and
// columns. Each is given back when it has been copied.
function read(body, at, names) {
  const view = new DataView(body.memory.buffer), shown = {};
  for (const name of names) {
    const dimensions = name === "facts" ? 1 : 2;
    const length = Number(view.getBigInt64(at + 8, true)), data = view.getUint32(at + 24, true);
    const shape = Array.from({ length: dimensions },
      (_, k) => Number(view.getBigInt64(at + 32 + 8 * k, true)));
    const numbers = new Float64Array(body.memory.buffer.slice(data, data + 8 * length));
    shown[name] = { numbers, shape };
    body.release(view.getUint32(at, true));
    at += 32 + 16 * dimensions;
  }
  return shown;
}
