#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Uses the start page and the sandbox in a headless Chromium: site_test.py PAGE PICTURES

PAGE is the folder that tools/web builds. Exit code: 0 all held, 1 something did not, 77 chromium or
chromedriver is missing."""
import json
import pathlib
import sys

from browser import Trial, bomb, judged, trial_of

SIZES = ((360, 640), (1280, 720), (1920, 1080))
FIRST_FRAME = 3.0  # s after the navigation
DRAG, DROP = 0, 1  # of kHands
CROWD = 200  # bodies
# Names without which a screen reader has nothing to say.
NAMELESS = """return [...document.querySelectorAll("button, input, select, canvas")].filter((one) =>
    !(one.labels?.length || one.textContent.trim() || one.ariaLabel)).map((one) => one.outerHTML);"""
# Small controls are hard to hit by a finger.
SMALL = """return [...document.querySelectorAll("button, select, .choice")].filter((one) => {
    const { width, height } = one.getBoundingClientRect();
    return width > 0 && (height < 36 || width < 36); }).map((one) => one.textContent);"""
# Graphs without a line.
EMPTY = """[...document.querySelectorAll("dl canvas")].filter((one) => !one.getContext("2d").getImageData(
    0, 0, one.width, one.height).data.some(Boolean)).length"""
BROKEN = """Promise.all([...document.querySelectorAll("a[href]")].map(async ({ href }) =>
    [href, (await fetch(href)).status])).then((all) => all.filter(([, code]) => code !== 200))"""
# Least time (ms) of a step and of a picture, in tens: other programs only add to it, and the clock is coarse.
FRAME_WORK = """const least = (work) => 0.1 * Math.min(...Array.from({ length: 12 }, () => {
        const start = performance.now();
        for (let i = 0; i < 10; ++i) { work(); }
        return performance.now() - start; }));
    return [least(() => sandbox.kodo.sandbox_step()), least(sandbox.draw)];"""
# Frames that the page draws in a second, while it simulates.
FRAME_RATE = """new Promise((done) => { let frames = 0; const start = performance.now();
    const next = (now) => now - start > 4000 ? done(1000 * frames / (now - start))
        : (++frames, requestAnimationFrame(next)); requestAnimationFrame(next); })"""


class Site(Trial):
    told = 0  # scenes, by the start page

    def start_page(self):
        for width, height in SIZES:
            self.browser.resize(width, height)
            self.browser.open(self.address)
            self.expect(self.wait("window.start.world.stepCount() > 20"), "the tower is simulated")
            self.fits(f"the start page at {width} x {height}")
            self.shot(f"start-{width}")
        self.told = int(self.number("document.body.innerText.match(/(\\d+) scenes/)[1]"))
        bodies = self.number("start.world.bodyCount()")
        self.browser.run("document.getElementById('canvas').focus();")
        self.browser.press("enter")
        self.expect(self.number("start.world.bodyCount()") == bodies + 1, "enter throws a ball")
        self.wait(f"start.world.stepCount() > {self.number('start.world.stepCount()') + 60}")
        self.browser.run("document.getElementById('undo').click();")
        self.expect("exactly" in self.number("document.getElementById('told').textContent"), "it goes back")
        self.expect(self.number("start.world.bodyCount()") in (bodies, bodies + 1), "to a World it had")
        self.expect(not self.browser.run(NAMELESS), "each control of the start page has a name")
        self.expect(not self.browser.later(BROKEN), f"its links lead somewhere {self.browser.later(BROKEN)}")
        self.browser.open(self.address + "pages/index.html")
        self.expect(not self.browser.later(BROKEN), "the links of the list of pages lead somewhere")
        self.browser.open(self.address + "pages/manual.html")
        self.shot("manual")

    def blocked(self):
        """Without one of its files a page tells so."""
        self.complain()
        self.browser.command("Network.enable", {})
        for page, files in (("", ("start.js", "kodo.js", "kodo.wasm")),
                            ("sandbox/", ("sandbox.js", "wasm.js", "sandbox.wasm"))):
            for name in files:
                self.browser.command("Network.setBlockedURLs", {"urls": [f"*/{name}"]})
                self.browser.open(self.address + page)
                self.expect(self.wait("document.body.innerText.includes('did not load')", 10),
                            f"without {name}, that is told")
                self.browser.faults()  # those of the blocked file
        self.browser.command("Network.setBlockedURLs", {"urls": []})

    def scene(self, name):
        self.browser.open(f"{self.address}sandbox/#{name.replace(' ', '%20')}")
        return self.wait("window.sandbox.kodo.sandbox_tick() >= 0")

    def sandbox(self):
        for width, height in SIZES:
            self.browser.resize(width, height)
            self.expect(self.scene("Big wheel"), f"the sandbox starts at {width} x {height}")
            self.wait("sandbox.kodo.sandbox_tick() > 60")
            self.fits(f"the sandbox at {width} x {height}")
            self.shot(f"sandbox-{width}")
        first = self.number("sandbox.ready") / 1000
        self.expect(first < FIRST_FRAME, f"its first frame comes {first:.2f} s after the page")
        scenes = self.number("sandbox.registry.scenes.length")
        listed = self.number("document.querySelectorAll('#scene option').length")
        self.expect(listed >= scenes == self.told, f"all of {self.told} scenes are listed ({listed}, {scenes})")
        self.expect(not self.browser.run(NAMELESS), f"each control has a name {self.browser.run(NAMELESS)}")
        self.expect(not self.browser.run(SMALL), f"fingers hit each control {self.browser.run(SMALL)}")
        self.expect(self.number("document.getElementById('question').textContent").endswith("?"),
                    "the question of the scene is shown")

    def verdict(self):
        self.scene("Big wheel")
        for _ in range(40):
            self.browser.run("for (let i = 0; i < 30; ++i) sandbox.kodo.sandbox_step();")
            if self.number("sandbox.kodo.sandbox_verdict()") >= 0:
                break
        self.wait("document.getElementById('verdict').textContent !== ''")
        self.expect(self.number("document.getElementById('verdict').textContent") == "As expected.",
                    "a scene without a touch is judged as expected")

    def not_judged(self):
        """What was touched is not judged, and that is told, until it starts again."""
        told = "document.getElementById('verdict').textContent"
        self.scene("Pendulum")
        self.browser.run("sandbox.kodo.sandbox_pointer(0, 1, 8, 8); sandbox.kodo.sandbox_pointer(2, 1, 8, 8);"
                         "for (let i = 0; i < 420; ++i) sandbox.kodo.sandbox_step();")
        self.expect(self.wait(f"{told}.startsWith('Not judged')", 5), f"a scene that was touched: {self.number(told)}")
        self.browser.run("document.getElementById('restart').click();")
        self.expect(self.wait(f"{told} === ''", 5), "a restart takes that back")

    def refused_clipboard(self):
        """A link that the clipboard refuses is shown, and no wider than the screen."""
        self.browser.resize(360, 640)
        self.scene("Pyramid")
        self.browser.run("navigator.clipboard.writeText = () => Promise.reject(new Error('no'));"
                         "document.getElementById('share').click();")
        message = "document.getElementById('message').textContent"
        self.expect(self.wait(f"{message}.includes('Copy this') && {message}.includes('#scene=')", 10),
                    "a link that cannot be copied is shown")
        self.fits("a long link")

    def panel(self):
        """Buttons show which profile is in use, and a hand is told without a move of the picture."""
        self.scene("Pyramid")
        pressed = "[...document.querySelectorAll('aside button[aria-pressed=true]')].map((one) => one.ariaLabel)"
        self.browser.run("document.querySelector('#profiles button').click();")
        self.expect(self.number(pressed) == ["Profile fast", "Compare with none"], "a profile is pressed")
        self.browser.run("document.querySelector('#compare button').click();")
        self.expect(self.number(pressed) == ["Profile fast", "Compare with fast"], "and one beside it")
        height = self.number("document.getElementById('canvas').clientHeight")
        self.browser.press("3")
        self.expect(self.number("document.getElementById('message').textContent").startswith("Draw: "),
                    "a hint names its hand")
        self.expect(self.number("document.getElementById('canvas').clientHeight") == height,
                    "a hint does not move the picture")
        water = "sandbox.registry.dials.findIndex(({ name }) => name === 'water')"
        self.expect(self.number(f"document.getElementById(`dial-${{{water}}}-input`).getAttribute('aria-valuetext')")
                    == "none", "absent water is none")

    def graphs(self):
        """Each measure of the registry has its value as text, and a graph of the last steps."""
        self.scene("Pyramid")
        measures = self.number("sandbox.registry.measures.length + sandbox.registry.stages.length")
        drawn = self.wait(f"document.querySelectorAll('dl canvas').length === {measures} && {EMPTY} === 0")
        self.expect(drawn is not None, f"{measures} measures have graphs")
        texts = self.number("[...document.querySelectorAll('dd:has(+ canvas)')].map((one) => one.textContent)")
        self.expect(len(texts) == measures and all(float(text.split()[0]) >= 0 for text in texts),
                    f"and their values beside them: {', '.join(texts)}")
        self.browser.run("document.getElementById('stages').scrollIntoView({ block: 'end' });")
        self.shot("graphs")

    def keyboard(self):
        self.browser.resize(1280, 720)
        self.scene("Pyramid")
        for _ in range(40):
            self.browser.press("tab")
            if self.number("document.activeElement.id") == "canvas":
                break
        self.expect(self.number("document.activeElement.id") == "canvas", "tab reaches the scene")
        self.browser.press(" ")
        self.expect(self.number("sandbox.state.paused"), "space pauses")
        tick = self.number("sandbox.kodo.sandbox_tick()")
        self.browser.press("n")
        self.expect(self.number("sandbox.kodo.sandbox_tick()") == tick + 1, "N makes one step")
        self.browser.press("b")
        self.expect(self.number("sandbox.kodo.sandbox_tick()") == tick, "B goes one step back")
        bodies = self.number("sandbox.kodo.sandbox_bodies()")
        for key in ("2", "up", "left", "enter", "enter"):
            self.browser.press(key)
        self.expect(self.number("sandbox.kodo.sandbox_bodies()") == bodies + 1,
                    "arrows and enter drop a body")
        self.shot("keyboard")
        self.browser.press("page down")
        self.expect(self.number("sandbox.state.scene") > 0, "page down opens the next scene")
        self.browser.run("document.querySelector('.dial:not([hidden]) input[type=range]').focus();")
        before = self.number("document.activeElement.value")
        self.browser.press("right")
        self.expect(self.number("document.activeElement.value") != before, "an arrow turns a dial")
        dial = self.number("sandbox.kodo.sandbox_dial(Number(document.activeElement.id.match(/\\d+/)[0]))")
        self.expect(abs(dial - float(self.number("document.activeElement.value"))) < 1e-6,
                    "and the engine has its value")

    def tours(self):
        """The guided tours, by their buttons, keys and links."""
        for width, height in SIZES:
            self.browser.resize(width, height)
            self.browser.open(f"{self.address}sandbox/#tour=Shock%20propagation%20off%20and%20on&stop=2")
            self.expect(self.wait("sandbox.kodo.sandbox_tick() > 121"), "a link opens a stop of a tour")
            self.wait("document.getElementById('verdict').textContent !== ''")
            self.expect(self.number("document.getElementById('verdict').textContent") == "As expected.",
                        "its overlap is as expected")
            self.expect(self.number("document.getElementById('difference').textContent").startswith("Red outlines: apart"),
                        "with and without shock passes are beside each other")
            self.fits(f"the tour at {width} x {height}")
            self.expect(not self.browser.run(SMALL), f"fingers hit each control {self.browser.run(SMALL)}")
            self.shot(f"tour-{width}")
        where = "document.getElementById('stop').textContent"
        self.browser.run("document.getElementById('stop-next').click();")
        self.expect("3 of 5" in self.number(where), "a button leads to the next stop")
        for _ in range(4):
            self.browser.press("page down")
        self.expect("5 of 5" in self.number(where), "page down goes to the last one, and no farther")
        self.browser.press("r")
        self.expect("5 of 5" in self.number(where) and self.number("sandbox.kodo.sandbox_tick()") < 30,
                    "a stop starts again")
        self.browser.run("document.getElementById('leave').click();")
        self.expect(self.number("document.getElementById('tour').hidden"), "a tour can be left")
        self.browser.run("const all = document.getElementById('scene'); all.value = 'tour 0';"
                         "all.dispatchEvent(new Event('change'));")
        self.expect(self.number(where) == "Iterations against overlap, 1 of 5", "the list has the tours")

    def share(self):
        self.scene("Pyramid")
        self.browser.run("""sandbox.state.paused = true;
            for (let i = 0; i < 40; ++i) sandbox.kodo.sandbox_step();
            sandbox.kodo.sandbox_pointer(0, 1, 0, 8); sandbox.kodo.sandbox_pointer(2, 1, 0, 8);""")
        state = "`${sandbox.kodo.sandbox_hash(0)} ${sandbox.kodo.sandbox_hash(1)}`"
        tick, was = self.number("sandbox.kodo.sandbox_tick()"), self.number(state)
        later = self.browser.run("const tick = sandbox.kodo.sandbox_tick();"
                                 "for (let i = 0; i < 60; ++i) sandbox.kodo.sandbox_step();"
                                 f"const later = {state}; sandbox.kodo.sandbox_rewind(tick); return later;")
        self.expect(self.number(state) == was, "a rewind has the bits of then")
        self.browser.allow_clipboard()
        self.browser.run("document.getElementById('share').click();")
        self.wait("document.getElementById('message').textContent.includes('clipboard')")
        link = self.clipboard()
        print(f"a World of {self.number('sandbox.kodo.sandbox_save()'):.0f} bytes is a link of {len(link)}")
        self.browser.open(link)
        self.wait(f"sandbox.kodo.sandbox_tick() > {tick}")
        same = self.browser.run(f"sandbox.state.paused = true; sandbox.kodo.sandbox_rewind({tick});"
                                f"return {state};")
        self.expect(same == was, "a link has the World with its bits")
        same = self.browser.run("for (let i = 0; i < 60; ++i) sandbox.kodo.sandbox_step();"
                                f"return {state};")
        self.expect(same == later, "and goes on with them")
        self.shot("shared")
        self.scene_file()
        self.browser.open(self.address + "sandbox/#scene=damaged")
        self.expect(self.wait("document.getElementById('message').textContent === 'The link is damaged.'"),
                    "a damaged link is told")
        with self.browser.before_pages("""const whole = Response.prototype.arrayBuffer;
                Response.prototype.arrayBuffer = async function () {
                    const bytes = await whole.call(this);
                    window.unpacked = bytes.byteLength;
                    return bytes; };"""):
            self.browser.open(self.address + "sandbox/#scene=" + bomb(400))
        self.expect(self.wait("document.getElementById('message').textContent.startsWith('More than 64 MB')"),
                    "a link that unpacks to 400 MB is told")
        read = self.number("window.unpacked")
        self.expect(read < 70e6, f"of which {read / 1e6:.1f} MB are unpacked")

    def scene_file(self):
        """A World as text goes out and in; a mistake is told and loses nothing."""
        self.scene("Big wheel")
        text = "(() => { const k = sandbox.kodo, at = k.sandbox_text(), all = new Uint8Array(k.memory.buffer, at);" \
               " return new TextDecoder().decode(all.subarray(0, all.indexOf(0))); })()"
        take = """const data = new DataTransfer();
            data.items.add(new File([arguments[0]], "wheel.toml"));
            const input = document.getElementById("file");
            input.files = data.files;
            input.dispatchEvent(new Event("change"));"""
        was = self.number(text)
        self.browser.run(take.replace("arguments[0]", json.dumps(was.replace("seconds", "second"))))
        message = "document.getElementById('message').textContent"
        self.expect(self.wait(f"{message}.includes('wheel.toml:2: unknown key second')"), "a mistake has its line")
        for content, reason in (("'x'.repeat(65e6)", "More than 64 MB"), ("''", "It is locked.")):
            self.browser.run(f"""const file = new File([{content}], "wheel.toml");
                if (file.size === 0) {{
                    file.arrayBuffer = () => Promise.reject(new Error("It is locked."));
                }}
                document.dispatchEvent(Object.assign(new Event("drop", {{ cancelable: true }}),
                                                     {{ dataTransfer: {{ files: [file] }} }}));""")
            self.expect(self.wait(f"{message}.startsWith('wheel.toml cannot be read. {reason}')", 10),
                        f"a file that cannot be read is told: {self.number(message)}")
        self.expect(self.number("!sandbox.state.file"), "and loses nothing")
        def loaded(content):
            self.browser.run(f"sandbox.state.paused = true; {message} = '';"
                             + take.replace("arguments[0]", json.dumps(content)))
            self.wait(f"{message} === 'Loaded wheel.toml.'")
            return self.number(text)

        read = loaded(was)  # a rotation in mid-motion may change by its last bit, once: scene_file.hpp
        self.expect(read.count("\n") == was.count("\n"), "a scene file is loaded")
        self.expect(loaded(read) == read, "a scene file gives the same text")
        self.expect(self.number("document.getElementById('scene').selectedIndex") == -1,
                    "no scene is selected, since none is shown")
        self.expect("not judged" in self.number("document.getElementById('expectation').textContent"),
                    "what was expected is told")
        self.shot("file")

    def examples(self):
        """Each example prints in the page what the native one prints, and draws its picture."""
        self.browser.open(self.address + "pages/examples.html")
        names = self.number("[...document.querySelectorAll('[data-run]')].map((one) => one.dataset.run)")
        self.expect(len(names) >= 24, f"{len(names)} examples have a button")
        for name in names:
            self.browser.run(f"document.querySelector('[data-run={name}]').click();")
            told = f"document.querySelector('#box-{name} output').textContent"
            self.wait(f"{told}.includes('.')", 60)
            self.expect("The same text as the native program printed." in self.number(told), f"{name}: {self.number(told)}")
        self.expect(self.wait("[...document.images].every((one) => one.complete && one.naturalWidth > 0)"),
                    "the pictures that they draw are shown")
        self.browser.run("document.querySelector('#box-hills').scrollIntoView();")
        self.shot("examples")

    def pointer(self, script):
        """The state after a scene, a script and 30 steps without time."""
        self.scene("Pyramid")
        self.browser.run("sandbox.state.paused = true; sandbox.kodo.sandbox_open(0);")
        self.browser.run(script)
        self.browser.run("for (let i = 0; i < 30; ++i) sandbox.kodo.sandbox_step();")
        return self.number("`${sandbox.kodo.sandbox_hash(0)} ${sandbox.kodo.sandbox_hash(1)}`")

    def links(self):
        """A link that names nothing opens the first scene or stop, and a sentence tells so."""
        message = "document.getElementById('message').textContent"
        wrong = {"#%": "names no scene: %", "#%E0%A4%A": "names no scene", "#Nothing": "names no scene: Nothing",
                 "#tour=Iterations%20against%20overlap&stop=abc": "has no stop abc"}
        for link, sentence in wrong.items():
            self.browser.open(f"{self.address}sandbox/{link}")
            self.wait("window.sandbox.kodo.sandbox_tick() > 2")
            self.expect(sentence in self.number(message), f"{link}: {self.number(message)}")
        self.browser.run("location.hash = '#%';")
        self.expect(self.wait(f"{message}.includes('names no scene: %')"), "a changed link is told as well")
        self.browser.run("location.hash = '#Big%20wheel';")
        self.expect(self.wait("document.title.startsWith('Big wheel')"), "and the next one is opened")

    def abandoned(self):
        """A pinch and a cancelled touch do not act; a wheel that turns to the side does not zoom."""
        for rest in ("['pointerdown', 2], ['pointerup', 2], ['pointerup', 1]", "['pointercancel', 1]"):
            self.scene("Pyramid")
            bodies = self.number("sandbox.kodo.sandbox_bodies()")
            self.browser.run(f"""sandbox.state.paused = true;
                sandbox.state.hand = {DROP};
                const canvas = document.getElementById("canvas");
                canvas.setPointerCapture = () => {{}};
                for (const [kind, pointerId] of [["pointerdown", 1], {rest}]) {{
                    canvas.dispatchEvent(new PointerEvent(kind, {{ pointerId, clientX: 90 + 40 * pointerId,
                        clientY: 200, pointerType: "touch" }}));
                }}""")
            self.expect(self.number("sandbox.kodo.sandbox_bodies()") == bodies, f"nothing is dropped by {rest}")
        self.browser.run("document.getElementById('canvas').dispatchEvent("
                         "new WheelEvent('wheel', { deltaX: 5, deltaY: 0 }));")
        self.expect(self.number("document.getElementById('message').textContent") == "", "and nothing is told")
        for width in (360, 1280):
            self.browser.resize(width, 200)
            self.expect(self.wait("document.getElementById('canvas').clientHeight >= 240", 5),
                        f"a window of {width} x 200 has a picture")

    def touch(self):
        self.browser.resize(360, 640)
        untouched = self.pointer("")
        self.expect(self.pointer("") == untouched, "a scene has the same bits again")
        self.scene("Pyramid")
        self.browser.run("sandbox.state.hand = 1;")
        bodies = self.number("sandbox.kodo.sandbox_bodies()")
        box = self.number("(({ x, y, width, height }) => [x + width / 2, y + height / 5])"
                          "(document.getElementById('canvas').getBoundingClientRect())")
        self.browser.tap(int(box[0]), int(box[1]))
        self.expect(self.number("sandbox.kodo.sandbox_bodies()") == bodies + 1, "a tap drops a body")
        self.browser.run("sandbox.state.hand = 0;")
        self.wait("sandbox.kodo.sandbox_tick() > 150")
        middle = self.number("(({ x, y, width, height }) => [x + width / 2, y + height * 0.75])"
                             "(document.getElementById('canvas').getBoundingClientRect())")
        self.browser.drag((int(middle[0]), int(middle[1])), (int(middle[0]) + 90, int(middle[1]) - 120))
        self.draws(30)
        self.shot("dragged")

    def home(self):
        self.browser.open(self.address + "apart/index.html")
        self.wait("Module._gameState(0) === 0")
        self.browser.run("document.getElementById('home').click();")
        self.expect(self.wait("window.start.world.stepCount() > 20"), "the game leads back to the start page")

    def frames(self):
        self.browser.resize(1280, 720)
        self.scene("Pyramid")
        self.browser.run(f"""const {{ kodo }} = sandbox;
            for (let i = 0; kodo.sandbox_bodies() < {CROWD}; ++i) {{
                const x = 1.2 * (i % 20) - 11.4, y = 16 + 1.2 * Math.floor(i / 20);
                kodo.sandbox_pointer(0, {DROP}, x, y);
                kodo.sandbox_pointer(2, {DROP}, x, y);
            }}""")
        step, picture = self.browser.run(FRAME_WORK)
        bodies = self.number("sandbox.kodo.sandbox_bodies()")
        self.draws(30)  # what was drawn is shown
        rate = self.browser.later(FRAME_RATE)
        print(f"{bodies:.0f} bodies: {step:.2f} ms a step, {picture:.2f} ms a picture; {rate:.0f} frames a second")
        self.expect(bodies == CROWD, f"a pyramid and what falls on it are {CROWD} bodies")
        self.expect(step + picture < 1000 / 60, "a frame of 60 in a second has time for both")
        self.shot("frames")


def refused(site):
    """With storage refused, all pages work."""
    site.browser.open(site.address)
    site.expect(site.wait("(() => { try { localStorage.length; return false; } catch { return true; } })()"),
                "storage is refused")
    site.expect(site.wait("window.start.world.stepCount() > 20"), "the start page runs then")
    site.expect(site.scene("Pyramid") and site.wait("sandbox.kodo.sandbox_tick() > 10"),
                "the sandbox runs then")
    site.browser.open(site.address + "apart/index.html")
    site.expect(site.wait("Module._gameState(0) === 0"), "the title of the game appears then")


def main(page, pictures):
    with trial_of(Site, page, pictures) as site:
        for part in (site.start_page, site.examples, site.sandbox, site.verdict, site.not_judged,
                     site.refused_clipboard, site.panel, site.graphs, site.keyboard,
                     site.tours, site.share, site.links, site.touch, site.abandoned, site.home,
                     site.frames, site.blocked):
            part()
    preferences = {"profile.default_content_setting_values.cookies": 2}
    with trial_of(Site, page, pictures, preferences=preferences) as without_storage:
        refused(without_storage)
    return judged([site, without_storage])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
