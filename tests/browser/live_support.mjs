// A render under way and its page, for tests; a way to it that can be cut.
import { spawn } from "node:child_process";
import { connect, createServer } from "node:net";

export const SIZE = { width: 160, height: 120 };

/** A render under way, once it has said its address. */
export async function startRender([program, scene], more) {
  const words = ["render", scene, "--resolution", `${SIZE.width}x${SIZE.height}`, "--photons-per-pass", "20000",
    "--aovs", "direct,indirect,albedo", "--light-group", "each", "--view", ...more];
  const child = spawn(program, words);
  const ended = new Promise((resolve) => child.on("close", resolve));
  const url = await new Promise((resolve) => {
    let said = "";
    child.stderr.on("data", (data) => {
      said += data;
      if (said.includes("\n")) resolve(said.split("\n")[0]);
    });
  });
  return { child, ended, url };
}

export const passesOf = (page) => page.$eval("#passes", (e) => Number.parseInt(e.textContent, 10) || 0);
export const waitForPass = (page, pass) =>
  page.waitForFunction((n) => Number.parseInt(document.getElementById("passes").textContent, 10) >= n, pass, { timeout: 60_000 });
export const waitForPicture = (page) =>
  page.waitForFunction((width) => document.getElementById("canvas-render").width === width, SIZE.width, { timeout: 60_000 });

/** The mean byte of the canvas. */
export const brightness = (page, of = "render") =>
  page.$eval(`#canvas-${of}`, (canvas) => {
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d"); // the page's own stays as it is
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) sum += data[i] + data[i + 1] + data[i + 2];
    return sum / data.length;
  });
export const scale = (page) => page.$eval("#canvas-render", (c) => Number(/scale\(([^,)]+)/.exec(c.style.transform)[1]));

/** A way to a port that can be cut, as a sleeping machine cuts it. */
export async function wayTo(port) {
  const open = new Set();
  const server = createServer((socket) => {
    const other = connect(port, "127.0.0.1");
    for (const [one, to] of [[socket, other], [other, socket]]) {
      open.add(one);
      one.on("error", () => one.destroy());
      one.on("close", () => {
        open.delete(one);
        to.destroy();
      });
      one.pipe(to);
    }
  });
  const listen = (at) => new Promise((resolve) => server.listen(at, "127.0.0.1", resolve));
  await listen(0);
  const { port: own } = server.address();
  const cut = () => {
    server.close();
    open.forEach((socket) => socket.destroy());
  };
  return { port: own, cut, mend: () => listen(own) };
}
