// wasm.js FILE FUNCTION NUMBER calls a function of a program built as WebAssembly. It prints the
// program's output and the result, if there is one.
const [file, name, number] = process.argv.slice(2);
const text = (at, length) => Buffer.from(instance.exports.memory.buffer, at, length).toString();
const program = new WebAssembly.Module(require("fs").readFileSync(file));
const instance = new WebAssembly.Instance(program, { golden: { line: (at, length) => console.log(text(at, length)) } });
const result = instance.exports[name](Number(number));
if (result !== undefined) console.log((result >>> 0).toString(16).padStart(8, "0"));
