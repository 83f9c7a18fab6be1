// Hash of the directions in Q14 as `tests/embedding/src/hashes.rs` has it, from a WebAssembly module:
// `node hash.mjs glint.wasm`, or `node hash.mjs sunglint.wasm` and the four constants of the light.
import { readFileSync } from "node:fs";

const [file, ...light] = process.argv.slice(2);
const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(file)));

const packed = (lanes) => new BigInt64Array(Int16Array.of(...lanes, 0).buffer)[0];
const lanes = (v) => new Int16Array(BigInt64Array.of(v).buffer).subarray(0, 3);
const scalars = {
    normalize: (v) => lanes(exports.normalize_q14(packed(v))),
    reflect: (n, v) => lanes(exports.reflect_q14(packed(n), packed(v))),
    cap: (l, r) => lanes(exports.cap_q14(packed(l), packed(r))),
};

// Memory from __heap_base on is the host's: a result, two vectors and a light.
const [result, first, second, sun] = [0, 8, 16, 24].map((offset) => exports.__heap_base.value + offset);
const vector = (address) => new Int16Array(exports.memory.buffer, address, 3);
const call = (name, vectors, ...more) => {
    vectors.forEach((v, i) => vector([first, second][i]).set(v));
    exports[`sunglint_${name}`](result, ...[first, second].slice(0, vectors.length), ...more);
    return vector(result).slice();
};
const structs = {
    normalize: (v) => call("normalize_q14", [v]),
    reflect: (n, v) => call("reflect_q14", [n, v]),
    cap: (l, r) => call("cap_q14", [l, r], sun),
};
if (light.length > 0) new Int32Array(exports.memory.buffer, sun, 4).set(light.map(Number));

let state = 0x5eed5eed;
const upperHalf = () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return state >> 16;
};

let hash = 0x811c9dc5;
const add = (byte) => { hash = Math.imul(hash ^ byte, 0x01000193); };

const { normalize, reflect, cap } = light.length > 0 ? structs : scalars;
for (let i = 0; i < 4096; i++) {
    const [n, v, l] = [0, 1, 2].map(() => normalize([upperHalf(), upperHalf(), upperHalf()]));
    const r = reflect(n, v);
    for (const lane of [n, v, l, r, cap(l, r)].flatMap((lanes) => [...lanes])) {
        add(lane & 255);
        add(lane >> 8 & 255);
    }
}
console.log((hash >>> 0).toString(16));
