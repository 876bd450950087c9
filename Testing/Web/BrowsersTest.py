# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tests of pages rely on: pixels are those that WebGL 2 drew, messages are seen, events are real."""
import base64
import hashlib
import unittest

import numpy as np

from browser_case import in_every_browser
from browsers import browser

STYLE = "html, body { margin: 0 } canvas { display: block; width: 100vw; height: 100vh; touch-action: none }"
# Red, green and blue take all 256 values, in squares of 3 pixels that tell where the picture begins.
DRAW = """
const canvas = document.querySelector("canvas");
canvas.width = innerWidth;
canvas.height = innerHeight;
const gl = canvas.getContext("webgl2");
const program = gl.createProgram();
function add(kind, text) {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, "#version 300 es\\n" + text);
  gl.compileShader(shader);
  gl.attachShader(program, shader);
}
add(gl.VERTEX_SHADER, `void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1);
}`);
add(gl.FRAGMENT_SHADER, `precision highp float;
  out vec4 color;
  void main() {
    ivec2 square = ivec2(gl_FragCoord.xy) / 3;
    color = vec4(ivec4(square.x, square.y, 7 * square.x + 13 * square.y, 255) & 255) / 255.;
  }`);
gl.linkProgram(program);
gl.useProgram(program);
function draw() {
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
}
function bytes() {
  draw();
  return new Promise(done => canvas.toBlob(blob => {
    const reader = new FileReader();
    reader.onload = () => done(reader.result);
    reader.readAsDataURL(blob);
  }));
}
function third() {
  const target = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, target);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 1, 1);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
  gl.clearColor(1 / 3, 0, 0, 1);
  gl.clear(gl.COLOR_BUFFER_BIT);
  const texel = new Float32Array(4);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, texel);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return texel[0];
}
window.bytes = bytes;
window.floats = gl.getExtension("EXT_color_buffer_float") ? third() : null;
draw();
requestAnimationFrame(() => { document.title = "ready"; });
"""
LISTEN = """window.events = [];
for (const kind of ["pointerdown", "pointermove", "pointerup", "wheel", "keydown"])
  addEventListener(kind, event => events.push({ kind, trusted: event.isTrusted, x: event.clientX, y: event.clientY,
    pointer: event.pointerType, id: event.pointerId, button: event.button, shift: event.shiftKey, key: event.key,
    turned: event.deltaY }));
"""


def page(script):
    """A page that may run this script and nothing else."""
    hashed = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    return f"""<!DOCTYPE html><meta charset="utf-8"><title>loading</title>
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'sha256-{hashed}';
 style-src 'unsafe-inline'"><style>{STYLE}</style><canvas></canvas><script type="module">{script}</script>"""


def drawn(width, height):
    """The picture of DRAW."""
    x, y = np.arange(width) // 3, (height - 1 - np.arange(height))[:, None] // 3
    return np.stack(np.broadcast_arrays(x, y, 7 * x + 13 * y), axis=2).astype(np.uint8)


class Browsers:
    def open(self, script):
        path = self.folder / f"{self._testMethodName}.html"
        path.write_text(page(script))
        self.browser.open(path, "bare")

    def events(self, kind):
        return [event for event in self.browser.run("return events") if event["kind"] == kind and event["trusted"]]

    def test_pixels(self):
        for width, height in (800, 790), (301, 203), (1921, 1081):
            with self.subTest(width=width, height=height):
                self.browser.size(width, height)
                self.open(DRAW)
                self.browser.wait_title("ready", 20)
                np.testing.assert_array_equal(self.browser.png(), drawn(width, height))
                np.testing.assert_array_equal(self.browser.pixels("return bytes()"), drawn(width, height))
                self.assertEqual(self.browser.console(), [])

    def test_renderer(self):
        self.assertIn(self.which[1], self.browser.renderer().lower())
        self.open(DRAW)
        self.assertEqual(self.browser.run("return floats"), float(np.float32(1 / 3)))

    def test_console(self):
        reported = {"warned": 'console.warn("warned")', "complained": 'console.error("complained")',
                    "nowhere": "nowhere()", "refused": 'Promise.reject(new Error("refused"))',
                    "Content": 'document.body.setAttribute("onclick", "nothing")',
                    "enable": 'document.querySelector("canvas").getContext("webgl2").enable(1)'}
        for word, script in reported.items():
            with self.subTest(script=script):
                self.open(script)
                said = self.browser.console()
                self.assertEqual(len(said), 1, said)
                self.assertIn(word, said[0])
                self.assertEqual(self.browser.console(), [])

    def test_title(self):
        self.open("")
        with self.assertRaisesRegex(TimeoutError, "'loading', not 'ready'"):
            self.browser.wait_title("ready", 0.1)
        self.open("nowhere()")
        with self.assertRaisesRegex(RuntimeError, "The console says: .*nowhere is not defined"):
            self.browser.wait_title("ready", 20)
        self.open('document.title = "failed"; document.body.append("no such thing")')
        with self.assertRaisesRegex(RuntimeError, "The page says: no such thing"):
            self.browser.wait_title("ready", 20)

    def test_mouse(self):
        self.open(LISTEN)
        self.browser.mouse((10, 20), (50, 60), button=1, keys=["Shift"])
        down, up = self.events("pointerdown")[0], self.events("pointerup")[0]
        self.assertEqual([down[key] for key in ("x", "y", "button", "shift")], [10, 20, 1, True])
        self.assertEqual([up[key] for key in ("x", "y", "button")], [50, 60, 1])
        self.browser.wheel(30, 40, 120)
        self.assertEqual([(e["x"], e["y"], e["turned"]) for e in self.events("wheel")], [(30, 40, 120)])

    def test_touch(self):
        self.open(LISTEN)
        self.browser.touch([(10, 20), (50, 60)], [(100, 90), (70, 80)])
        self.assertEqual({e["pointer"] for e in self.events("pointerdown")}, {"touch"})
        self.assertEqual(len({e["id"] for e in self.events("pointerdown")}), 2)
        self.assertEqual({(e["x"], e["y"]) for e in self.events("pointerup")}, {(50, 60), (70, 80)})

    def test_keys(self):
        self.open(LISTEN)
        self.browser.keys("r", "ArrowLeft", "Tab")
        self.assertEqual([e["key"] for e in self.events("keydown")], ["r", "ArrowLeft", "Tab"])


in_every_browser(Browsers)


class BrowsersTest(unittest.TestCase):
    def test_end(self):
        for which in ("chromium", "swiftshader"), ("firefox", "llvmpipe"):
            with self.subTest(which=which):
                with self.assertRaisesRegex(RuntimeError, "of the test"), browser(*which) as opened:
                    raise RuntimeError("of the test")
                with self.assertRaises(OSError):
                    opened.renderer()

    def test_refused(self):
        with self.assertRaisesRegex(ValueError, "Firefox draws with the llvmpipe, not with swiftshader"):
            with browser("firefox", "swiftshader"):
                pass


if __name__ == "__main__":
    unittest.main()
