// SPDX-License-Identifier: MIT
// Plays the scenes of the page of tools/crosscheck. Python inlines it; the data is in the page.
"use strict";

(() => {
  // Inverse of pack() in crosscheck_player.py.
  const unpack = async (text) => {
    const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    const planes = new Uint8Array(await new Response(stream).arrayBuffer());
    const count = planes.length / 2;
    const result = new Int32Array(count);
    for (let i = 0; i < count; ++i) {
      const zigzag = planes[i] | (planes[count + i] << 8);
      result[i] = (zigzag >> 1) ^ -(zigzag & 1);
    }
    return result;
  };

  // Reads channels one after another: second differences, of places modulo 2^16.
  const channels = (numbers) => {
    let next = 0;
    return (count, List = Int16Array) => {
      const values = new List(count);
      let change = 0;
      for (let i = 0; i < count; ++i) {
        change += numbers[next++];
        values[i] = (i > 0 ? values[i - 1] : 0) + change;
      }
      return values;
    };
  };

  const decode = (film, numbers) => {
    const read = channels(numbers);
    return film.plays.map((play) => {
      const times = read(play.frames, Float64Array).map((time) => time / film.times);
      const bodies = play.bodies.map(([body, frames]) => ({
        body,
        first: play.frames - frames, // a piece appears at its split
        x: read(frames),
        y: read(frames),
        angle: read(frames),
      }));
      return { times, bodies, splits: play.splits };
    });
  };

  // The frame at or before a time, and the share of the way to the next one.
  const frameAt = (times, time) => {
    let low = 0;
    let high = times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= time + 1e-6) low = middle;
      else high = middle - 1;
    }
    const next = Math.min(low + 1, times.length - 1);
    const way = times[next] - times[low];
    return { frame: low, share: way > 0 ? Math.min(Math.max((time - times[low]) / way, 0), 1) : 0 };
  };

  class Player {
    constructor(section) {
      this.section = section;
      this.box = section.querySelector(".player");
      this.film = JSON.parse(this.box.querySelector("script").textContent);
      this.slider = this.box.querySelector("input");
      this.button = this.box.querySelector("button.run");
      this.output = this.box.querySelector("output");
      this.canvas = section.querySelector("canvas");
      this.box.hidden = false;
      this.slider.addEventListener("input", () => this.show(Number(this.slider.value)));
      this.button.addEventListener("click", () => this.toggle());
      this.slider.addEventListener("keydown", (event) => {
        if (event.key === " ") {
          event.preventDefault();
          this.toggle();
        }
      });
      for (const mark of this.box.querySelectorAll(".marks button")) {
        mark.addEventListener("click", () => this.show(Number(mark.dataset.time)));
      }
    }

    load() {
      this.loading ??= unpack(this.film.data).then((numbers) => {
        this.plays = decode(this.film, numbers);
      });
      return this.loading;
    }

    // Places of all bodies of a play: body, x and y (m), angle (rad).
    placesAt(index, time) {
      const { times, bodies } = this.plays[index];
      const { frame, share } = frameAt(times, time);
      const { unit, angles, middle } = this.film;
      return bodies
        .filter((one) => frame >= one.first)
        .map((one) => {
          const i = frame - one.first;
          const j = Math.min(i + 1, one.x.length - 1);
          const mix = (list) => list[i] + share * (list[j] - list[i]);
          let turn = (one.angle[j] - one.angle[i]) % angles;
          turn -= angles * Math.round(turn / angles);
          return {
            body: one.body,
            x: middle[0] + unit * mix(one.x),
            y: middle[1] + unit * mix(one.y),
            angle: ((one.angle[i] + share * turn) * 2 * Math.PI) / angles,
          };
        });
    }

    // The parts of each body at a frame: splits make bodies of parts.
    partsAt(index, time) {
      const { times, splits } = this.plays[index];
      const { frame } = frameAt(times, time);
      const parts = new Map(this.film.bodies.map(([body, shapes]) => [body, [...shapes.entries()]]));
      let next = this.film.count;
      for (const [from, body, part] of splits) {
        if (from > frame) break;
        const owned = parts.get(body);
        const at = owned.findIndex(([number]) => number === part);
        parts.set(next++, owned.splice(at, 1));
      }
      return parts;
    }

    draw(time) {
      const sharp = Math.max(window.devicePixelRatio || 1, 2);
      const [left, top, scale, width, height] = this.film.view;
      this.canvas.width = width * sharp;
      this.canvas.height = height * sharp;
      const pen = this.canvas.getContext("2d");
      this.film.looks.forEach(([colour, dash, stroke, opacity], index) => {
        pen.setTransform(sharp, 0, 0, sharp, 0, 0);
        pen.strokeStyle = colour;
        pen.lineWidth = stroke;
        pen.globalAlpha = opacity;
        pen.setLineDash(dash);
        const parts = this.partsAt(index, time);
        for (const at of this.placesAt(index, time)) {
          const c = Math.cos(at.angle);
          const s = Math.sin(at.angle);
          const put = ([x, y]) => [
            (at.x + c * x - s * y - left) * scale,
            (top - at.y - s * x - c * y) * scale,
          ];
          for (const [, part] of parts.get(at.body) || []) {
            pen.beginPath();
            if (part.radius !== undefined) {
              const [x, y] = put(part.center);
              pen.arc(x, y, part.radius * scale, 0, 2 * Math.PI);
              pen.moveTo(x, y); // a radius shows the angle
              pen.lineTo(...put([part.center[0] + part.radius, part.center[1]]));
            } else {
              part.corners.forEach((corner) => pen.lineTo(...put(corner)));
              pen.closePath();
            }
            pen.stroke();
          }
        }
      });
    }

    async show(time) {
      this.wanted = Math.min(Math.max(time, 0), this.film.end);
      this.slider.value = this.wanted;
      this.output.textContent = `${this.wanted.toFixed(2)} s`;
      this.section.classList.add("playing");
      await this.load();
      this.draw(this.wanted);
    }

    async toggle() {
      this.running = !this.running;
      this.button.textContent = this.running ? "❚❚" : "▶";
      this.button.setAttribute("aria-label", this.running ? "Pause" : "Play");
      if (!this.running) return;
      await this.load();
      if (!(this.wanted < this.film.end)) this.wanted = 0;
      let last = null;
      const next = (now) => {
        if (!this.running) return;
        this.show(this.wanted + (last === null ? 0 : (now - last) / 1000));
        last = now;
        if (this.wanted >= this.film.end) this.toggle();
        else requestAnimationFrame(next);
      };
      requestAnimationFrame(next);
    }
  }

  for (const section of document.querySelectorAll("section")) {
    if (section.querySelector(".player")) section.player = new Player(section);
  }
})();
