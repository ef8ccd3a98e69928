// The report of a run: charts and views from the data in the page. All texts are set as texts, never as HTML.
"use strict";

function element(tag, name = "", text = "", attributes = {}, children = []) {
  const made = document.createElement(tag);
  if (name) made.className = name;
  if (text) made.append(text);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// Packed data: base64 of zlib's format.
async function unpack(text) {
  const packed = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Numbers of 8 bytes (d) or of 4 (f).
async function numbers(text) {
  const bytes = await unpack(text.slice(1));
  return text[0] === "d" ? new Float64Array(bytes.buffer) : new Float32Array(bytes.buffer);
}

const format = value => value == null || !Number.isFinite(value) ? "" : String(Number(value.toPrecision(6)));

async function makeChart(box, chart) {
  const tables = [], columns = await Promise.all(chart.columns.map(numbers));
  const hole = value => Number.isFinite(value) ? value : null;
  for (const group of chart.groups) tables.push([Array.from(columns[group.x]), ...group.ys.map(y => Array.from(columns[y], hole))]);
  const data = tables.length > 1 ? uPlot.join(tables) : tables[0];
  const series = [{label: chart.x, value: (_, v) => format(v)}];
  // About sixty markers of what is seen.
  const some = (plot, i) => {
    const [low, high] = plot.series[0].idxs, there = [];
    for (let k = low; k <= high; ++k) if (plot.data[i][k] != null) there.push(k);
    const step = Math.max(1, Math.ceil(there.length / 60));
    return there.filter((_, k) => k % step === 0);
  };
  for (const line of chart.lines)
    series.push({label: line.label, stroke: line.colour, width: line.points ? 0 : 1.4, dash: line.dash, spanGaps: tables.length > 1,
                 points: line.points ? {show: true, filter: some, size: 5, width: 1, stroke: line.colour, fill: "#fff"} : {show: false}, value: (_, v) => format(v)});
  const place = element("div", "plot");
  box.append(place);
  const size = () => ({width: Math.max(260, box.clientWidth - 2), height: Math.max(220, Math.min(420, Math.round(0.5 * box.clientWidth)))});
  const letters = {font: "12px sans-serif", labelFont: "12px sans-serif"};
  const plot = new uPlot({...size(), series, scales: {x: {time: false, distr: chart.log[0] ? 3 : 1}, y: {distr: chart.log[1] ? 3 : 1}},
    axes: [{label: chart.x, ...letters}, {label: chart.y, size: 64, values: (_, ticks) => ticks.map(t => t == null ? "" : format(t)), ...letters}],
    cursor: {drag: {x: true, y: true, uni: 24}, focus: {prox: 24}}, legend: {live: true}}, data, place);
  const ends = () => [plot.scales.x.min, plot.scales.x.max];
  const zoom = (factor, shift = 0) => {
    const [low, high] = ends(), middle = 0.5 * (low + high) + shift * (high - low), half = 0.5 * factor * (high - low);
    plot.setScale("x", {min: chart.log[0] ? Math.max(middle - half, low / 2) : middle - half, max: middle + half});
  };
  const bar = element("div", "controls");
  for (const [text, title, act] of [["+", "zoom in", () => zoom(0.5)], ["\u2212", "zoom out", () => zoom(2)], ["\u25c0", "to the left", () => zoom(1, -0.25)],
                                    ["\u25b6", "to the right", () => zoom(1, 0.25)], ["all", "the whole curve", () => plot.setData(data)],
                                    ["csv", "save these values", () => save(chart, data)]]) {
    const button = element("button", "", text, {type: "button", title});
    button.addEventListener("click", act);
    bar.append(button);
  }
  box.append(bar);
  new ResizeObserver(() => { if (box.clientWidth) plot.setSize(size()); }).observe(box);
}

function save(chart, data) {
  const quote = text => `"${String(text).replaceAll('"', '""')}"`;
  const rows = [[chart.x, ...chart.lines.map(line => line.label + " " + chart.y)].map(quote).join(",")];
  for (let i = 0; i < data[0].length; ++i) rows.push(data.map(column => column[i] ?? "").join(","));
  const link = element("a", "", "", {download: chart.name + ".csv"});
  link.href = URL.createObjectURL(new Blob([rows.join("\n") + "\n"], {type: "text/csv"}));
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function start() {
  const data = JSON.parse(document.getElementById("data").textContent);
  const fail = (box, error) => { box.classList.add("failed"); box.append(element("p", "note", "This part cannot be shown: " + error.message)); };
  const make = async box => {
    try {
      if (typeof DecompressionStream === "undefined") throw new Error("the browser is older than 2023");
      if (box.dataset.chart !== undefined) await makeChart(box, data.charts[box.dataset.chart]);
      else {
        const maps = {};
        for (const [name, text] of Object.entries(data.maps)) maps[name] = await unpack(text);
        box.view = new BodyView(box, data.views[box.dataset.view], maps, unpack);
        await box.view.draw();
      }
      box.dataset.done = "yes";
      document.getElementById(box.dataset.picture)?.classList.add("replaced");
    } catch (error) {
      fail(box, error);
    }
  };
  // What comes into view is made; before the page is printed all of it.
  const boxes = [...document.querySelectorAll("[data-chart], [data-view]")];
  const watch = new IntersectionObserver(entries => {
    for (const entry of entries) if (entry.isIntersecting) { watch.unobserve(entry.target); make(entry.target); }
  }, {rootMargin: "400px"});
  boxes.forEach(box => watch.observe(box));
  window.addEventListener("beforeprint", () => boxes.forEach(box => { if (!box.dataset.done) { watch.unobserve(box); make(box); } }));
}

start();
