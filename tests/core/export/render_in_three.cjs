// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// node render_in_three.cjs NODE_MODULES CHROMIUM MODEL.gltf OUT.raw SIDE THETA
// Renders the model by three.js in headless chromium as tests/core/export/sun_picture.h describes. OUT.raw: SIDE^2 pixels
// of three floats, the bottom row first.
const fs = require('fs');
const os = require('os');
const path = require('path');
const url = require('url');

const [modules, chromium, model, out, side, theta] = process.argv.slice(2);
const at = file => url.pathToFileURL(path.join(modules, 'three', file)).href;
const page = `<!doctype html><script type="importmap">{"imports": {"three": "${at('build/three.module.js')}"}}</script>
<script type="module">
import * as THREE from 'three';
import {GLTFLoader} from '${at('examples/jsm/loaders/GLTFLoader.js')}';
window.picture = async (text, side, theta) => {
  const model = await new GLTFLoader().parseAsync(text, '');
  const scene = new THREE.Scene();
  scene.add(model.scene);
  const sun = new THREE.DirectionalLight(0xffffff, Math.PI);
  sun.position.set(Math.sin(theta), 0, Math.cos(theta));
  scene.add(sun);
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 100);
  camera.position.z = 50;
  const renderer = new THREE.WebGLRenderer();
  const scale = 4;
  const target = new THREE.WebGLRenderTarget(scale * side, scale * side, {type: THREE.FloatType});
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  const pixels = new Float32Array(4 * scale * side * scale * side);
  renderer.readRenderTargetPixels(target, 0, 0, scale * side, scale * side, pixels);
  const mean = new Array(3 * side * side).fill(0);
  for (let y = 0; y < scale * side; ++y)
    for (let x = 0; x < scale * side; ++x)
      for (let c = 0; c < 3; ++c)
        mean[3 * (Math.floor(y / scale) * side + Math.floor(x / scale)) + c] += pixels[4 * (y * scale * side + x) + c] / scale ** 2;
  return mean;
};
window.ready = true;
</script>`;

async function main() {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'gonio-three-'));
  const html = path.join(folder, 'page.html');
  fs.writeFileSync(html, page);
  const browser = await require(path.join(modules, 'puppeteer-core')).launch({
    executablePath: chromium,
    headless: true,
    userDataDir: path.join(folder, 'profile'),
    args: ['--no-sandbox', '--allow-file-access-from-files', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  try {
    const tab = await browser.newPage();
    tab.on('pageerror', error => console.error(String(error)));
    tab.on('console', message => console.error(message.text()));
    await tab.goto(url.pathToFileURL(html).href);
    await tab.waitForFunction('window.ready', {timeout: 30000});
    const mean = await tab.evaluate((...a) => window.picture(...a), fs.readFileSync(model, 'utf8'), Number(side), Number(theta));
    fs.writeFileSync(out, Buffer.from(new Float32Array(mean).buffer));
  } finally {
    await browser.close();
    fs.rmSync(folder, {recursive: true, force: true});
  }
}

main().catch(error => {
  console.error(String(error.stack || error));
  process.exit(1);
});
