// A program in the part of an address after #: `v1.` and the program as JSON, deflated, in base64url. That part
// of an address is never sent to a server. The build writes the same form (tests/site/links.py).

const VERSION = "v1.";
// A program is a few kilobytes; a link that unpacks to more is refused as soon as it does.
const MAX_TEXT = 262144;

export class BadLink extends Error {}

export async function toFragment({ name, dialect, program, machine }) {
  const text = new TextEncoder().encode(JSON.stringify({ name, dialect, program, machine }));
  if (text.length > MAX_TEXT) throw new BadLink("The program is too long for a link.");
  const packed = new Response(new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw")));
  const bytes = new Uint8Array(await packed.arrayBuffer());
  const characters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return VERSION + btoa(characters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

export async function fromFragment(fragment) {
  if (!fragment.startsWith(VERSION)) throw new BadLink("This link is not one of this playground.");
  let shared;
  try {
    shared = JSON.parse(await inflated(fragment.slice(VERSION.length)));
  } catch (error) {
    if (error instanceof BadLink) throw error;
    throw new BadLink("This link is damaged or incomplete.");
  }
  const { name, dialect, program, machine } = shared ?? {};
  const texts = [name, dialect, program, machine];
  if (!texts.every((each) => typeof each === "string") || !["mint", "mccl"].includes(dialect)) {
    throw new BadLink("This link has no program.");
  }
  return { name, dialect, program, machine };
}

async function inflated(base64url) {
  const characters = atob(base64url.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(characters, (each) => each.charCodeAt(0));
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const decoder = new TextDecoder("utf-8", { fatal: true });
  let text = "";
  for (let size = 0; ; ) {
    const { done, value } = await reader.read();
    if (done) return text + decoder.decode();
    size += value.length;
    if (size > MAX_TEXT) {
      reader.cancel().catch(() => {});
      throw new BadLink("This link unpacks to more than a program may have.");
    }
    text += decoder.decode(value, { stream: true });
  }
}
