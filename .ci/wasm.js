// wasm.js FILE: runs the firmware built as WebAssembly, and prints the hash of all its frames.
const bytes = require("fs").readFileSync(process.argv[2]);
WebAssembly.instantiate(bytes).then(({ instance }) => {
  console.log((instance.exports.firmware_hash() >>> 0).toString(16).padStart(8, "0"));
});
