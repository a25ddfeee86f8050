// HTML that was made of Markdown, without what could load or run something. The Markdown has comments of the program.

const ALLOWED = new Set("A B BLOCKQUOTE BR CODE EM H1 H2 H3 H4 HR I LI OL P PRE SPAN STRONG TABLE TBODY TD TH THEAD TR UL".split(" "));

export function clean(html) {
  // A parsed document loads nothing and runs nothing.
  const { body } = new DOMParser().parseFromString(html, "text/html");
  for (const element of body.querySelectorAll("*")) {
    if (!ALLOWED.has(element.tagName)) {
      element.replaceWith(element.outerHTML);
      continue;
    }
    for (const { name } of [...element.attributes]) if (name !== "class") element.removeAttribute(name);
  }
  return body.innerHTML;
}
