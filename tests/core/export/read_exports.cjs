// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// node read_exports.cjs NODE_MODULES FILE: exit code 0 where the file's own program takes it. A .gltf: the validator of
// Khronos finds no error. A .mtlx: MaterialX validates it, and makes a shader of it.
const fs = require('fs');
const path = require('path');

const [modules, file] = process.argv.slice(2);

async function checkGltf() {
  const validator = require(path.join(modules, 'gltf-validator'));
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
  if (report.issues.numErrors > 0 || report.issues.numWarnings > 0) throw new Error(JSON.stringify(report.issues.messages));
}

/// The module as it is made for browsers.
async function materialX() {
  const folder = path.join(modules, '@needle-tools/materialx/bin/');
  const source = fs.readFileSync(folder + 'JsMaterialXGenShader.js', 'utf8').replace('export default MaterialX;', '');
  const holder = {exports: {}};
  new Function('module', 'exports', 'require', '__filename', '__dirname', source)(
      holder, holder.exports, require, folder + 'JsMaterialXGenShader.js', folder);
  const data = fs.readFileSync(folder + 'JsMaterialXGenShader.data.txt');
  return holder.exports({
    locateFile: name => folder + name,
    wasmBinary: fs.readFileSync(folder + 'JsMaterialXGenShader.wasm'),
    getPreloadedPackage: () => data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength),
  });
}

async function checkMaterialX() {
  const mx = await materialX();
  const generator = mx.EsslShaderGenerator.create();
  const context = new mx.GenContext(generator);
  const library = mx.loadStandardLibraries(context);
  const document = mx.createDocument();
  document.importLibrary(library);
  await mx.readFromXmlString(document, fs.readFileSync(file, 'utf8'), '');
  if (!document.validate()) throw new Error('MaterialX does not validate it');
  const element = mx.findRenderableElement(document);
  const shader = generator.generate(element.getNamePath(), element, context);
  if (!(shader.getSourceCode('pixel').length > 1000)) throw new Error('MaterialX makes no shader of it');
}

(file.endsWith('.gltf') ? checkGltf() : checkMaterialX()).catch(error => {
  console.error(String(error.message || error));
  process.exit(1);
});
