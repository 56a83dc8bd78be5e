// SPDX-License-Identifier: GPL-3.0-or-later
// The rows that the table shows as texts to be copied: CSV with all digits, Markdown and LaTeX as they are read.

const headingsOf = () => [...nameColumns, ...columns].map(({ heading }) => heading);

function csvTable(rows) {
  const numbers = (row) => columns.map((column) => (row.error ? null : column.shown(row)));
  return csvText([[...headingsOf(), "Error"], ...rows.map((row) => [...nameColumns.map(({ text }) => text(row)), ...numbers(row), row.error])]);
}

/** No cell of its own, no HTML. */
const markdownEscaped = (text) => text.replaceAll("|", "\\|").replaceAll("<", "&lt;").replace(/\s+/g, " ");

function markdownTable(rows) {
  const line = (cells) => `| ${cells.map(markdownEscaped).join(" | ")} |\n`;
  const cells = (row) => (row.error ? [`failed: ${row.error}`] : columns.map((column) => column.textWithInterval(row)));
  const rule = `|${nameColumns.map(() => "---|").join("")}${columns.map(() => "---:|").join("")}\n`;
  return line(headingsOf()) + rule + rows.map((row) => line([...nameColumns.map(({ text }) => text(row)), ...cells(row)])).join("");
}

const latexSigns = { "\\": "\\textbackslash{}", "~": "\\textasciitilde{}", "^": "\\textasciicircum{}", "<": "\\textless{}", ">": "\\textgreater{}", "|": "\\textbar{}" };
const latexEscaped = (text) => text.replace(/[&%$#_{}]/g, "\\$&").replace(/\\(?![&%$#_{}])|[~^<>|]/g, (sign) => latexSigns[sign]);

/** 1.23·10⁻⁴ as $1.23\cdot10^{-4}$. */
function latexNumber(text) {
  const plain = (digits) => [...digits].map((c) => "-0123456789"["⁻⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c)]).join("");
  return text.replace(/·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/g, (_, power) => `$\\cdot10^{${plain(power)}}$`)
    .replaceAll("∞", "$\\infty$").replaceAll(">", "$>$").replaceAll("–", "--").replaceAll("\u202f", "\\,");
}

function latexTable(rows, standing) {
  const cell = (column, row) => {
    const text = latexNumber(column.textWithInterval(row));
    return standing.get(row)[column.name] === "best" ? `{\\boldmath\\textbf{${text}}}` : text;
  };
  const cells = (row) => (row.error ? [`\\multicolumn{${columns.length}}{l}{failed: ${latexEscaped(row.error)}}`] : columns.map((column) => cell(column, row)));
  const line = (list) => `${list.join(" & ")} \\\\\n`;
  const head = line(headingsOf().map(latexEscaped));
  const body = rows.map((row) => line([...nameColumns.map(({ text }) => latexEscaped(text(row))), ...cells(row)])).join("");
  return `% needs \\usepackage{booktabs}\n\\begin{tabular}{ll${"r".repeat(columns.length)}}\n\\toprule\n${head}\\midrule\n${body}\\bottomrule\n\\end{tabular}\n`;
}

/** To the clipboard, or, where the browser gives none to a page, to a file. */
async function copyText(text, name) {
  try {
    await navigator.clipboard.writeText(text);
    return "copied";
  } catch {
    saveFile(name, new Blob([text], { type: "text/plain" }));
    return "saved, as this browser lets no page copy";
  }
}

/** Buttons that copy the rows that `shown` returns. */
function copyButtons(shown, standing) {
  const said = make("span", { role: "status", class: "note" });
  const button = (kind, ending, text) => make("button", { type: "button", title: `Copy the rows below as ${kind}`,
    onclick: async () => { said.textContent = `${kind} ${await copyText(text(shown()), `table.${ending}`)}`; } }, kind);
  return make("span", { class: "copies" }, "copy as ", button("CSV", "csv", csvTable), button("Markdown", "md", markdownTable),
              button("LaTeX", "tex", (rows) => latexTable(rows, standing)), " ", said);
}
