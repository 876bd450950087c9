# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A view in a browser, drawn by this process: remote_view.py [FILE] [--width 900] [--height 600] [--port P] [--rate 20]

While the mouse is down, coarse frames are sent as JPEG, as many a second as --rate says; at rest a full one as PNG. A
full frame that is being drawn is aborted when the mouse moves. All of OpenGL runs in the main thread; the server's
threads only take wishes and hand out the newest frame. It serves this computer alone.
"""
import argparse
import json
import threading
import time
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import vtktetmarch
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

PAGE = b"""<!DOCTYPE html><title>TetMarch</title><body style="margin:0;background:#111">
<img draggable="false" style="touch-action:none"><script type="module">
let img = document.querySelector("img"), wish = null, sends = false;
img.onpointerdown = img.onpointermove = img.onpointerup = img.onwheel = e => {
  if (e.type == "pointermove" && !e.buttons) return;
  if (e.type == "pointerdown") img.setPointerCapture(e.pointerId);
  const [x, y, wheel] = wish || [0, 0, 0];
  wish = [x + e.movementX, y + e.movementY, wheel + (e.deltaY || 0), e.buttons > 0];
  return sends || send(), false;
};
async function send() {  // what gathers while a message is under way is sent in the next
  for (sends = true; wish;) {
    const body = JSON.stringify(wish);
    wish = null;
    await fetch("/wish", {method: "POST", body});
  }
  sends = false;
}
for (let taken = 0;;) {  // the answer comes when there is another frame than the one taken
  const answer = await fetch("/frame?taken=" + taken), old = img.src;
  if (answer.status != 200) continue;
  taken = answer.headers.get("X-Frame");
  img.src = URL.createObjectURL(await answer.blob());
  URL.revokeObjectURL(old);
}
</script>"""


class View:
    """A figure that the main thread draws, and what the server's threads wish for."""

    def __init__(self, figure, rate):
        self.figure, self.rate = figure, rate
        self.changed = threading.Condition()
        self.number, self.frame, self.taken = 0, b"", 0  # the newest frame; the number of the one the browser has
        self.wish = [0, 0, 0]  # drag to the right and downwards, turn of the wheel, in pixels
        self.wished = self.down = self.is_full = False
        figure.mapper.SetMaxDrawTimeInSeconds(0.1)  # between draws it is asked whether to abort
        self.window = figure.render().renderer.GetRenderWindow()
        self.window.AddObserver("AbortCheckEvent", self.check)

    def check(self, window, _event):
        """Called while a frame is drawn, in which the server's threads don't run: they get some time here."""
        time.sleep(0.005)
        if self.is_full and self.wished:
            window.SetAbortRender(1)

    def add(self, wish):
        with self.changed:
            self.wish = [old + new for old, new in zip(self.wish, wish)]
            self.down, self.wished = wish[3], True
            self.changed.notify_all()

    def newest(self, taken, seconds=10):
        """(number, bytes) of the newest frame, when it is another than the one taken; None if there is none."""
        with self.changed:
            self.taken = taken
            self.changed.notify_all()
            return (self.number, self.frame) if self.changed.wait_for(lambda: self.number != taken, seconds) else None

    def run(self):
        """Draws until KeyboardInterrupt: when the last frame was taken, and something is wished or it wasn't full."""
        while True:
            with self.changed:
                while self.taken != self.number or not self.wished and (self.down or self.is_full):
                    self.changed.wait(0.5)  # without a time, Ctrl+C could be missed
                (x, y, wheel), self.wish, self.wished = self.wish, [0, 0, 0], False
                self.is_full = not (self.down or x or y or wheel)
            camera = self.figure.camera
            camera.Azimuth(-0.4 * x)
            camera.Elevation(0.4 * y)
            camera.OrthogonalizeViewUp()
            camera.Zoom(2 ** (-wheel / 400))
            self.window.SetDesiredUpdateRate(0.001 if self.is_full else self.rate)
            self.figure.render()
            if not self.window.GetAbortRender():
                self.show(vtkPNGWriter() if self.is_full else vtkJPEGWriter())

    def show(self, writer):
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ShouldRerenderOff()
        writer.SetInputConnection(grab.GetOutputPort())
        writer.WriteToMemoryOn()
        writer.Write()
        with self.changed:
            self.number, self.frame = self.number + 1, vtk_to_numpy(writer.GetResult()).tobytes()
            self.changed.notify_all()


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"  # connections stay open

    def answer(self, status, body=b"", kind="text/html", number=0):
        self.send_response(status)
        for header in (("Content-Type", kind), ("Content-Length", len(body)), ("X-Frame", number)):
            self.send_header(*map(str, header))
        self.end_headers()
        self.wfile.write(body)

    def do_GET(self):
        if self.headers["Host"] not in (f"127.0.0.1:{server.server_port}", f"localhost:{server.server_port}"):
            self.answer(403)  # to a page of another name, which leads here
        elif self.path.startswith("/frame?taken="):
            number, frame = view.newest(int(self.path.split("=")[1])) or (0, b"")
            self.answer(200 if number else 204, frame, "image/png" if b"PNG" in frame[:4] else "image/jpeg", number)
        else:
            self.answer(200, PAGE)

    def do_POST(self):
        view.add(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.answer(204)

    def log_message(self, *_):
        """Quiet."""


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", default="Data/golfball_small.vtu")
    for name, default in (("width", 900), ("height", 600), ("port", 0), ("rate", 20)):
        parser.add_argument("--" + name, type=int, default=default)
    given = parser.parse_args()
    view = View(vtktetmarch.figure(given.file, size=(given.width, given.height)), given.rate)
    server = ThreadingHTTPServer(("127.0.0.1", given.port), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    print(f"http://127.0.0.1:{server.server_port}/ (Ctrl+C ends)", flush=True)
    try:
        view.run()
    except KeyboardInterrupt:
        server.shutdown()
