// SPDX-License-Identifier: GPL-3.0-or-later
// Begins when the program has said what the scene holds.

(async () => {
  try {
    Object.assign(data, await askJson("scene"));
    document.title = `${data.name} · Pellucid`;
    document.getElementById("title").textContent = data.name;
    document.getElementById("holds").textContent = data.holds;
    if (data.report) document.querySelector(".head").append(make("a", { href: "../../report/report.html" }, "report"));
    new Live();
  } catch (error) {
    const element = document.getElementById("error");
    element.textContent = error.message;
    element.hidden = false;
  }
})();
