// The library writes for the command line: "--wall 25 would do". On the page that is a field, by its name there.

/** What the page calls a flag, in one language; also a flag with a word behind it, "--blocks auto", that is one choice. */
export type FlagNames = ReadonlyMap<string, string>;

/** Lists that the page shows by itself: in brackets, or as the last thing that is said. */
const LISTS = /\s*[(（][^()（）]*`snug (?:cases|foams|inspect)\b[^()（）]*[)）]|(?:; |(?<=。))`snug cases\b[^;。]*。?/g;
/** A whole command is to be typed elsewhere, and stays. */
const COMMAND = /(`[^`]*`|(?<=[:：]\s?)snug [a-z][\s\S]*$)/;
const FLAG = /(--[a-z][a-z-]*)(?:[ =](-?\d[\d.]*(?:[x,]-?\d[\d.]*)*|[a-z][\w.-]*(?:\/[a-z][\w.-]*)*))?/g;

export function withFieldNames(sentence: string, names: FlagNames, quoted: (name: string) => string): string {
  const named = (typed: string, flag: string, value?: string) => {
    const choices = value?.split('/').map((word) => names.get(`${flag} ${word}`));
    if (choices?.every((choice) => choice !== undefined)) return choices.map((choice) => quoted(choice)).join(' / ');
    const name = names.get(flag);
    if (name === undefined) return typed;
    return value === undefined ? quoted(name) : `${quoted(name)} ${spaced(value)}`;
  };
  const parts = sentence.replace(LISTS, '').split(COMMAND);
  return parts.map((part, i) => (i % 2 === 0 ? part.replace(FLAG, named).replace(/ (?=「)|(?<=」) /g, '') : part)).join('');
}

/** Several numbers as people read them. */
function spaced(value: string): string {
  return value.replace(/(?<=\d)x(?=-?\d)/g, ' × ').replace(/,(?=-?\d)/g, ', ');
}
