// Puts the article together of docs/article and the core: OUT/article.html, one file with everything in it, and
// OUT/web/article.html, which shares the core with the page beside it.
// SPDX-License-Identifier: GPL-3.0-or-later
import { build, transform } from "esbuild";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { toHtml } from "./prose.mjs";

const here = dirname(fileURLToPath(import.meta.url)), prose = join(here, "../../docs/article");

export function articleProse() {
  const names = readdirSync(prose).filter(name => /^\d+-.*\.md$/.test(name)).sort();
  return names.map(name => {
    const section = "part-" + name.replace(/^\d+-|\.md$/g, "");
    const html = toHtml(readFileSync(join(prose, name), "utf8"), section);
    return { section, title: /<h2[^>]*>(.*?)<\/h2>/.exec(html)?.[1], html };
  });
}

/// `glue`: the script that starts the core; `inside`: the element that holds the packed core; `licence`: what it says of
/// itself.
export async function writeArticle({ outFolder, glue, inside, licence }) {
  const { outputFiles } = await build({
    entryPoints: [join(here, "main.ts")], bundle: true, minify: true, format: "iife", target: "es2022", write: false,
    legalComments: "none",
  });
  const css = readFileSync(join(here, "style.css"), "utf8");
  const style = (await transform(css, { loader: "css", minify: true })).code;
  const sections = articleProse();
  const body = sections.map(({ section, html, title }) =>
    title ? `<section aria-labelledby="${section}">\n${html}\n</section>` : html).join("\n");
  const contents = sections.filter(({ title }) => title).map(({ section, title }) =>
    `<li><a href="#${section}">${title.replace(/^\d+\s+/, "")}</a></li>`).join("");
  const put = (text, mark, value) => text.replace(`<!--${mark}-->`, () => value);
  let page = readFileSync(join(here, "page.html"), "utf8");
  page = put(page, "body", put(body, "contents", ""));
  page = put(page, "contents", contents);
  page = put(page, "licence", licence.split("\n\n").map(one => `<p>${one}</p>`).join(""));
  page = put(page, "style", `<style>${style}</style>`);
  const script = `${glue}\n${outputFiles[0].text}`.replaceAll("</script", "<\\/script");
  const single = put(put(page, "payload", inside), "script", `<script>${script}</script>`);
  const hosted = put(put(page, "payload", ""), "script", `<script src="article.js" defer></script>`)
    .replaceAll('href="sightline.html#', 'href="index.html#');
  writeFileSync(join(outFolder, "article.html"), single);
  writeFileSync(join(outFolder, "web/article.html"), hosted);
  writeFileSync(join(outFolder, "web/article.js"), script);
  console.log(`${join(outFolder, "article.html")}: ${Math.round(Buffer.byteLength(single) / 1000)} kB, of which ` +
              `prose ${Math.round(body.length / 1000)} and script ${Math.round(outputFiles[0].text.length / 1000)}`);
}
