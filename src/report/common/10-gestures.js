// Fingers, mouse and wheel on a picture.
"use strict";

/** One finger or the mouse moves, two zoom, as the wheel does.
 *  @param does  pan(dx, dy, shifts) in screen pixels, `shifts`: with the Shift key;
 *               zoom(factor, x, y) about a place of the screen; hover(place), null where the pointer
 *               has left; if wanted ignores(target): what has a use of its own, and start(x, y) and
 *               end() of one finger or the mouse. */
function onGestures(element, does) {
  const touching = new Map();
  element.addEventListener("pointerdown", (event) => {
    if (does.ignores?.(event.target)) return;
    element.setPointerCapture(event.pointerId);
    element.classList.add("dragging");
    touching.set(event.pointerId, [event.clientX, event.clientY]);
    if (touching.size === 1) does.start?.(event.clientX, event.clientY);
  });
  element.addEventListener("pointermove", (event) => {
    const here = [event.clientX, event.clientY];
    does.hover(here);
    const before = touching.get(event.pointerId);
    if (!before) return;
    const others = [...touching].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    touching.set(event.pointerId, here);
    if (others.length === 0) return does.pan(here[0] - before[0], here[1] - before[1], event.shiftKey);
    const [x, y] = others[0];
    const distance = (at) => Math.max(1, Math.hypot(at[0] - x, at[1] - y));
    does.zoom(distance(here) / distance(before), (here[0] + x) / 2, (here[1] + y) / 2);
  });
  for (const name of ["pointerup", "pointercancel"])
    element.addEventListener(name, (event) => {
      if (!touching.delete(event.pointerId) || touching.size > 0) return;
      element.classList.remove("dragging");
      does.end?.();
    });
  element.addEventListener("pointerleave", () => does.hover(null));
  element.addEventListener("wheel", (event) => {
    event.preventDefault();
    does.zoom(2 ** (-event.deltaY / 300), event.clientX, event.clientY);
  }, { passive: false });
}
