// The page: it draws what the core says and forwards what people do. It decides nothing about a run.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Boot } from "./boot";
import { Core, type Binding, type Look, type SceneChoice, type Tables } from "./core";
import { about, askLine, chooseScene, commandLine, dialog, showKeys, showMenu } from "./dialogs";
import { byId, download, make, rowElement } from "./dom";
import { Flight } from "./flight";
import { FormulaField } from "./formula";
import { belongsToFocus, bindings, keyName } from "./keys";
import { packState, readAddress } from "./link";
import { labelFont } from "./paint";
import { Pane } from "./pane";
import { loadCore } from "./payload";
import { settingsElements } from "./settings";
import { Timeline } from "./timeline";
import { tradeOffChart } from "./trade_off";
import { Transport } from "./transport";

declare const licence: string, boot: Boot;

class App {
  private tables!: Tables;
  private scenes: SceneChoice[] = [];
  private keys = new Map<string, Binding>();
  private look!: Look;
  private readonly panes: Pane[] = [];
  private readonly transport: Transport;
  private readonly timeline: Timeline;
  private readonly formula = new FormulaField(text => this.tryFormula(text));
  private readonly flight = new Flight(by => { this.core.fly(by); this.refreshSoon(); });
  private dimension = 0;
  private settingsOpen = false;
  private drawPending = false;
  private panelText = "";
  private saidLines: { text: string; bad: boolean }[] = [];
  private addressTimer = 0;
  private idleTimer = 0;
  private playedAt = 0;
  private ownHash = "";

  constructor(private readonly core: Core) {
    this.transport = new Transport({ run: command => this.run(command), seek: step => this.run(`seek ${step}`) });
    this.timeline = new Timeline(step => this.run(`seek ${step}`));
    this.scenes = core.scenes();
    this.buildTools();
    this.listen();
  }

  /// Those that a narrow page shows in the menu alone come last.
  private buildTools() {
    const few: [string, () => void, string][] = [
      ["Scenes", () => this.run("scenes"), "Choose a scene (O)"],
      ["Lessons", () => this.run("lesson"), "Lessons (F2)"],
      ["Menu", () => showMenu(this.tables, more, command => this.run(command), begin => this.ask(begin)),
       "Every command"],
    ];
    const more: [string, () => void, string][] = [
      ["Compare", () => this.run("show compare"), "Two runs beside each other (5)"],
      ["Settings", () => this.run("show settings"), "Every setting (Shift+S)"],
      ["Open file", () => this.pickFile(), "JSON, GeoJSON, WAD, OBJ, PLY, STL, OFF, glTF; or drop it on the page"],
      ["SVG", () => this.run("picture svg"), "Save the picture as SVG"],
      ["PNG", () => this.run("picture png"), "Save the picture as PNG"],
      ["Export page", () => this.run("page"), "Save what is shown as a page that opens at it, to hand out"],
      ["Link", () => void this.copyLink(), "Copy a link to what is shown"],
      ["Keys", () => this.run("help"), "All keys (F1)"],
      ["About", () => about(licence), "Licence and sources"],
    ];
    for (const [label, act, title] of [...few, ...more])
      byId("tools").append(make("button", { type: "button", title, onclick: act,
                                            class: more.some(one => one[0] === label) ? "more" : "" }, label));
    const skip = document.querySelector<HTMLAnchorElement>(".skip")!;
    skip.addEventListener("click", event => { event.preventDefault(); byId("panel").focus(); });
  }

  private listen() {
    addEventListener("keydown", event => this.key(event));
    addEventListener("resize", () => this.redraw());
    new ResizeObserver(() => this.redraw()).observe(byId("panes"));
    addEventListener("hashchange", () => { if (location.hash !== this.ownHash) void this.openAddress(); });
    addEventListener("dragover", event => { event.preventDefault(); document.body.classList.add("dropping"); });
    addEventListener("dragleave", event => {
      if (!event.relatedTarget) document.body.classList.remove("dropping");
    });
    addEventListener("drop", event => {
      event.preventDefault();
      document.body.classList.remove("dropping");
      if (event.dataTransfer?.files.length) void this.openFiles([...event.dataTransfer.files]);
    });
    addEventListener("paste", event => {
      const text = event.clipboardData?.getData("text") ?? "";
      if (text.includes('"sightline-state"')) this.attempt(() => this.core.openState(text));
    });
  }

  private ask(begin: string) { commandLine(this.tables, command => this.run(command), begin); }

  private key(event: KeyboardEvent) {
    const name = keyName(event);
    if (!name || event.defaultPrevented || belongsToFocus(event, name)) return;
    if (name === "Escape") {
      if (this.panes.some(pane => pane.cancel())) return this.refresh();
      if (this.look.desk.blank) return this.run("blank");
      if (this.look.desk.projector) return this.run("projector");
      return;
    }
    if (this.look.flight && this.flight.key(event)) return event.preventDefault();
    const binding = this.keys.get(name);
    if (!binding) return;
    event.preventDefault();
    binding.asks ? this.ask(binding.command + " ") : this.run(binding.command);
  }

  /// What the page itself does; false: the core's.
  private own(command: string): boolean {
    const [word, ...rest] = command.split(" "), argument = rest.join(" ");
    if (command === "scenes") chooseScene(this.scenes, one => this.run(one));
    else if (command === "lesson") chooseScene(this.scenes, one => this.run(one), "Lessons");
    else if (command === "help") showKeys(this.tables);
    else if (command === "console") this.ask("");
    else if (command === "open") this.pickFile();
    else if (command === "copy") void navigator.clipboard.writeText(this.core.state()).then(
      () => this.say("state copied to the clipboard, as text"),
      () => this.say("the browser keeps its clipboard to itself", true));
    else if (command === "paste") this.say("press Ctrl+V to open the state on the clipboard");
    else if (command === "quit") this.say("close the tab to end this page");
    else if (command === "fullscreen") void (document.fullscreenElement ? document.exitFullscreen()
                                                                        : document.documentElement.requestFullscreen());
    else if (command === "show settings") { this.settingsOpen = !this.settingsOpen; this.refresh(); }
    else if (command === "page") this.run(`page ${this.fileName()}-${this.look.position}.html`);
    else if (word === "picture" || word === "shot") this.savePicture(argument.endsWith("png") ? "png" : "svg");
    else return false;
    return true;
  }

  run(command: string) {
    if (this.own(command.trim())) return;
    const slow = this.tables.commands.find(one => one.id === command.split(" ")[0])?.slow;
    const go = () => this.attempt(() => this.core.run(command));
    if (!slow) return go();
    this.say(slow);
    setTimeout(go, 30);
  }

  /// What is wrong with the formula is said where it is typed.
  private tryFormula(text: string): string {
    this.saidLines = [];
    this.core.run(`set key="${text.replaceAll('"', " ")}"`);
    this.refresh();
    const wrong = this.saidLines.filter(line => line.bad).map(line => line.text).join(" ");
    if (wrong) this.saidLines = [];
    this.showSaid();
    return wrong.replace(/^[^]*?(?=column \d+: )/, "");  // whose command and setting it is shows already
  }

  private say(text: string, bad = false) {
    this.saidLines = [{ text, bad }];
    this.showSaid();
  }
  private showSaid() {
    byId("said").replaceChildren(...this.saidLines.slice(-6).map(line =>
      make("span", { class: line.bad ? "bad" : "" }, line.text + " ")));
  }

  private attempt(act: () => void) {
    this.saidLines = [];
    try { act(); } catch (error) { this.saidLines.push({ text: (error as Error).message, bad: true }); }
    this.takeWrittenFiles();
    this.refresh();
  }

  /// Files that a command wrote become downloads.
  private takeWrittenFiles() {
    const files = this.core.files;
    for (const name of files.readdir("/files")) {
      if (name === "." || name === ".." || this.dropped.has(name)) continue;
      const bytes = files.readFile("/files/" + name);
      files.unlink("/files/" + name);
      if (!name.endsWith(".html")) download(name, bytes as BlobPart, "application/octet-stream");
      else void boot.pageWith(new TextDecoder().decode(bytes)).then(text => download(name, text, "text/html"));
    }
  }
  private readonly dropped = new Set<string>();

  private fileName() { return this.look.scene.replace(/^.*\//, "").replace(/[^\w.-]+/g, "-"); }

  private savePicture(kind: "svg" | "png") {
    const name = this.fileName();
    if (kind === "svg") download(`${name}.svg`, this.panes[0].svg(this.look.headline), "image/svg+xml");
    else void this.panes[0].png().then(blob => download(`${name}.png`, blob, "image/png"));
    this.say(`${name}.${kind} is in the downloads`);
  }

  private pickFile() {
    const field = make("input", { type: "file", multiple: true });
    field.addEventListener("change", () => void this.openFiles([...field.files ?? []]));
    field.click();
  }
  async openFiles(files: File[]) {
    const names: string[] = [];
    for (const file of files) {
      const name = file.name.replace(/[\\/;"]/g, "_");
      this.core.files.writeFile("/files/" + name, new Uint8Array(await file.arrayBuffer()));
      this.dropped.add(name);
      names.push(name);
    }
    const first = names.find(name => /\.(gltf|json|geojson|wad|obj|ply|stl|off|glb)$/i.test(name)) ?? names[0];
    this.attempt(() => this.core.open(first));
  }

  /// What the page came with is opened before what the address asks for.
  async openAddress(handout = "") {
    let asked = {} as Awaited<ReturnType<typeof readAddress>>;
    try { asked = await readAddress(location.hash); }
    catch { this.saidLines.push({ text: "the address holds no state that can be read", bad: true }); }
    try {
      if (handout) this.core.openState(handout);
      if (asked.state) this.core.openState(asked.state);
      else if (asked.open || !handout) this.core.open(asked.open ?? "bottleneck");
      if (asked.commands) this.core.run(asked.commands);
    } catch (error) {
      this.saidLines.push({ text: (error as Error).message, bad: true });
      if (this.dimension === 0) this.core.open("bottleneck");
    }
    this.refresh();
  }
  private async writeAddress() {
    if (this.look.source !== "generated") return;
    const hash = "#" + await packState(this.core.handout());
    if (hash.length > 8000 || this.look.state === "playing") return;
    this.ownHash = hash;
    history.replaceState(null, "", hash);
  }
  private async copyLink() {
    await this.writeAddress();
    if (this.look.source !== "generated") return this.say("a link holds no file: Export page does", true);
    navigator.clipboard?.writeText(location.href).then(() => this.say("the link is on the clipboard"),
                                                       () => this.say("copy the address of this page"));
  }

  /// Everything follows the core.
  refresh() {
    this.look = this.core.look();
    const look = this.look;
    for (const line of look.said ?? []) this.saidLines.push(line);
    if (look.dimension !== this.dimension) {
      this.dimension = look.dimension;
      this.tables = this.core.tables();
      this.keys = bindings(this.tables.commands);
    }
    while (this.panes.length < look.panes) this.addPane();
    while (this.panes.length > look.panes) this.panes.pop()!.element.remove();
    document.title = `${look.title || look.scene} – Sightline`;
    byId("headline").textContent = look.headline;
    byId("step").textContent = look.step + (look.result ? ` ${look.result}.` : "") + ` (${look.guarantee})`;
    document.body.classList.toggle("projector", look.desk.projector);
    document.body.classList.toggle("blank", look.desk.blank);
    this.showSaid();
    this.transport.update(look, () => this.core.curve());
    this.timeline.update(look, () => this.core.curve());
    this.formula.show(look.formula);
    if (!look.flight) this.flight.stop();
    this.showTabs();
    this.showPanel();
    this.showLesson();
    this.showSettings();
    this.redraw();
    clearTimeout(this.addressTimer);
    this.addressTimer = window.setTimeout(() => void this.writeAddress(), 500);
    clearTimeout(this.idleTimer);
    this.idleTimer = window.setTimeout(() => this.idle(), 400);
    if (look.state === "playing" && this.playedAt === 0) this.play();
  }

  private addPane() {
    const pane = new Pane(this.core, this.panes.length, {
      changed: () => this.refreshSoon(),
      run: command => this.run(command),
      turn: (right, up) => {
        if (!this.look.flight) return false;
        this.core.fly([0, 0, 0], right, up);
        this.refreshSoon();
        return true;
      },
      hover: cell => { for (const one of this.panes) one.outline(cell); },
    });
    this.panes.push(pane);
    byId("panes").append(pane.element);
  }

  private soon = 0;
  private refreshSoon() {
    if (this.soon) return;
    this.soon = requestAnimationFrame(() => { this.soon = 0; this.refresh(); });
  }

  private redraw() {
    if (this.drawPending || this.dimension === 0) return;
    this.drawPending = true;
    requestAnimationFrame(() => {
      this.drawPending = false;
      for (const pane of this.panes) pane.draw(this.look.desk.legend && this.panes.length === 1);
      if (!this.drawn) { this.drawn = true; performance.mark("first picture"); document.body.dataset.ready = "yes"; }
    });
  }
  private drawn = false;

  private play() {
    const frame = (now: number) => {
      const seconds = this.playedAt ? (now - this.playedAt) / 1000 : 0;
      this.playedAt = now;
      if (this.core.tick(Math.min(seconds, 0.25))) this.refresh();
      if (this.look.state === "playing") requestAnimationFrame(frame);
      else { this.playedAt = 0; this.refresh(); }
    };
    requestAnimationFrame(frame);
  }

  private idle() {
    if (this.panes.some(pane => pane.busy) || this.look.state === "playing") return;
    if (this.core.idle(60)) this.refresh();
  }

  private tabsOf = "";
  private showTabs() {
    byId("side").hidden = !this.look.panel;
    const of = `${this.dimension} ${this.look.desk.right}`;
    if (of === this.tabsOf) return;
    this.tabsOf = of;
    const tabs = byId("tabs"), focused = tabs.contains(document.activeElement)
      ? (document.activeElement as HTMLElement).dataset.id : undefined;
    tabs.replaceChildren(...this.tables.panels.filter(panel => panel.id !== "settings").map(panel => {
      const here = panel.id === this.look.desk.right;
      return make("button", { type: "button", title: panel.text, "data-id": panel.id, "aria-current": String(here),
                              onclick: () => { if (panel.id !== this.look.desk.right) this.run(`show ${panel.id}`); } },
                  panel.title);
    }));
    if (focused) tabs.querySelector<HTMLElement>(`[data-id="${focused}"]`)?.focus();
  }

  private readonly rowActions = {
    run: (command: string) => this.run(command),
    hover: (cell: number | null) => { for (const pane of this.panes) pane.outline(cell); },
    light: (about: number, light: [number, number, number]) =>
      this.panes[0]?.lightUp(about ? this.core.light(about, light) : []),
  };

  private showPanel() {
    const text = JSON.stringify(this.look.panel ?? []);
    if (text === this.panelText) return;
    this.panelText = text;
    this.panes[0]?.lightUp([]);
    const panel = byId("panel"), title = this.tables.panels.find(one => one.id === this.look.desk.right)?.title;
    panel.setAttribute("aria-label", title ?? "Panel");
    const rows: Node[] = (this.look.panel ?? []).map(row => rowElement(row, this.rowActions));
    const chart = this.look.desk.right === "trade-off" && tradeOffChart(this.core.tradeOff(), this.rowActions.run);
    if (chart) rows.unshift(chart);
    panel.replaceChildren(...rows);
    panel.scrollTop = 0;
  }

  private lessonText = "";
  private showLesson() {
    const box = byId("lesson"), text = JSON.stringify([this.look.lesson, this.look.teaching, this.look.speaker]);
    box.hidden = this.look.lesson.length === 0;
    if (text === this.lessonText) return;
    this.lessonText = text;
    if (box.hidden) return box.replaceChildren();
    const button = (label: string, command: string) =>
      make("button", { type: "button", onclick: () => command ? this.run(command) : this.answer() }, label);
    const buttons = [button("Back", "previous"), button("Next (PageDown)", "next")];
    if (this.look.teaching?.asksKey) buttons.push(button("Answer …", ""));
    buttons.push(button("End lesson", "lesson end"));
    box.replaceChildren(...this.look.lesson.map(row => rowElement(row, this.rowActions)),
                        ...(this.look.speaker ?? []).map(row => rowElement(row, this.rowActions)),
                        make("div", { class: "buttons" }, ...buttons));
    this.transport.forget();
    this.timeline.forget();
  }
  private answer() { askLine("The key of the cell", text => this.run(`answer ${text}`)); }

  private settingsText = "";
  private showSettings() {
    const box = byId("settings");
    box.hidden = !this.settingsOpen;
    if (box.hidden) return;
    const settings = this.core.settings(), text = JSON.stringify(settings);
    if (text === this.settingsText && box.firstChild) return;
    this.settingsText = text;
    const label = box.contains(document.activeElement) ? document.activeElement?.getAttribute("aria-label") : null;
    box.replaceChildren(...settingsElements(settings, this.tables, command => this.run(command)));
    if (label) box.querySelector<HTMLElement>(`[aria-label="${CSS.escape(label)}"]`)?.focus();
  }
}

/// Widths of characters as the labels are drawn, for the core to stand them without overlap.
function characterWidths(): number[] {
  const to = document.createElement("canvas").getContext("2d")!;
  to.font = `100px ${labelFont}`;
  const width = (text: string) => to.measureText(text).width / 100;
  return [...Array(128).keys()].map(i => i < 32 || i === 127 ? 0 : width(String.fromCharCode(i))).concat(width("ρ"));
}

async function start() {
  byId("panes").append(make("p", { class: "wait" }, "loading …"));
  try {
    const core = new Core(await loadCore(boot.parts));
    const failed = core.selfTest(2000);
    if (failed) throw new Error(`exact geometry is not exact in this browser (${failed}), so nothing is shown`);
    core.setFont(characterWidths());
    byId("panes").replaceChildren();
    const app = new App(core);
    await app.openAddress(boot.handout);
    Object.assign(window, { app, core });
  } catch (error) {
    const words = `This page cannot start: ${(error as Error).message}`;
    byId("panes").replaceChildren(make("p", { class: "wait", role: "alert" }, words));
  }
}

dialog().addEventListener("click", event => { if (event.target === dialog()) dialog().close(); });
void start();
