import { FluentBundle, FluentNumber, FluentResource, type FluentVariable } from '@fluent/bundle';
import FIRST from './first.json';
import type { ArgumentView, MessageView, QuantityView } from '../wire';

/** Languages by their codes, each called by its own name. */
export const languages = { en: 'English', uk: 'Українська', zh: '中文', de: 'Deutsch', ru: 'Русский' } as const;
export type Language = keyof typeof languages;

/** A language, or English with accents and 40 % more letters, which shows words that are in no catalogue. */
export type Tongue = Language | 'pseudo';

/** Catalogues of the repository that the panel uses, by path. */
const FILES = import.meta.glob<string>(['../../../messages/*/*.ftl', '!../../../messages/*/cli.ftl', '!../../../messages/*/report.ftl'], { query: '?raw', import: 'default' });

/** Loads the catalogues of a language: those that every page needs, or all others. */
export async function load(language: Language, part: 'first' | 'rest'): Promise<string[]> {
  const files = Object.entries(FILES).filter(([path]) => {
    const [of = '', area = ''] = path.split('/').slice(-2);
    return of === language && FIRST.includes(area.replace('.ftl', '')) === (part === 'first');
  });
  return Promise.all(files.map(([, file]) => file()));
}

/** The words of one language; formats messages as `crates/message/src/catalogue.rs` does. */
export class Catalogue {
  readonly language: Language;
  readonly #bundle: FluentBundle;
  readonly #sign: string;

  constructor(tongue: Tongue, sources: readonly string[]) {
    this.language = tongue === 'pseudo' ? 'en' : tongue;
    this.#sign = ['en', 'zh'].includes(this.language) ? '.' : ',';
    // Marks of Unicode around arguments would be in texts that are copied.
    this.#bundle = new FluentBundle(this.language, { useIsolating: false, ...(tongue === 'pseudo' && { transform: accented }) });
    for (const source of sources) this.#bundle.addResource(new FluentResource(source));
  }

  has(code: string): boolean {
    return this.#pattern(code) !== null;
  }

  /** The words of a code; null for a code without words, or without an argument that its words need. */
  words(code: string, of: Record<string, FluentVariable>): string | null {
    const pattern = this.#pattern(code);
    if (pattern === null) return null;
    const errors: Error[] = [];
    const text = this.#bundle.formatPattern(pattern, of, errors);
    return errors.length === 0 ? text : null;
  }

  /** Text of a message; its English text if there are no words for it. */
  text(message: MessageView): string {
    const of = Object.fromEntries(message.arguments.map(([name, argument]) => [name, this.#value(argument)]));
    return this.words(message.code, of) ?? message.text;
  }

  #pattern(code: string): Parameters<FluentBundle['formatPattern']>[0] | null {
    return this.#bundle.getMessage(code)?.value ?? null;
  }

  #value(argument: ArgumentView): string | FluentNumber {
    switch (argument.type) {
      case 'quantity':
        return this.#withUnit(this.#number(argument.value), argument.value.unit);
      case 'range':
        return this.#withUnit(argument.value.map((end) => this.#number(end)).join('–'), argument.value[0].unit);
      // As a number it selects the plural form.
      case 'count':
        return whole(argument.value);
      case 'pass':
        return String(argument.value);
      case 'message':
        return this.text(argument.value);
      case 'list':
        return argument.value.map((item) => (item.type === 'count' ? String(item.value) : String(this.#value(item)))).join(', ');
      default:
        return argument.value;
    }
  }

  #withUnit(number: string, unit: string): string {
    return unit === '' ? number : (this.words(unit, { number }) ?? `${number} ${unit.replace('unit-', '')}`);
  }

  #number(of: QuantityView): string {
    const text = rounded(of.value, of.decimals);
    // No negative zero.
    return (/^-[0.]*$/.test(text) ? text.slice(1) : text).replace('.', this.#sign);
  }
}

/** A count, without marks between thousands. */
export function whole(count: number): FluentNumber {
  return new FluentNumber(count, { useGrouping: false });
}

/** A number with so many decimals; what lies in the middle goes to the even neighbour, as in Rust. */
function rounded(value: number | null, decimals: number): string {
  if (value === null) return 'NaN';
  const scaled = Math.abs(value) * 10 ** decimals;
  const isMiddle = Number.isInteger(value * 2 ** (decimals + 1)) && scaled % 1 === 0.5;
  const even = 2 * Math.round(scaled / 2);
  return (isMiddle ? (Math.sign(value) * even) / 10 ** decimals : value).toFixed(decimals);
}

const ACCENTS: Record<string, string> = { a: 'áá', e: 'éé', i: 'íí', o: 'óó', u: 'úú', n: 'ñ', c: 'ç', s: 'š', A: 'ÁÁ', E: 'ÉÉ', S: 'Š', C: 'Ç' };

/** Puts accents on letters, and repeats vowels. */
export function accented(text: string): string {
  return [...text].map((letter) => ACCENTS[letter] ?? letter).join('');
}
