/** A node of a JSON schema, as much of it as the formats' own schemas use. */
type Node = {
  $ref?: string;
  $defs?: Record<string, Node>;
  description?: string;
  type?: string | string[];
  const?: unknown;
  enum?: unknown[];
  default?: unknown;
  properties?: Record<string, Node>;
  additionalProperties?: boolean | Node;
  items?: Node;
  minItems?: number;
  minimum?: number;
  exclusiveMinimum?: number;
  required?: string[];
  anyOf?: Node[];
  oneOf?: Node[];
};

/** A key that a table may have and does not have yet: what it is, and the value that it is added with, as TOML. */
export type Addable = { key: string; value: string; help: string };

/** Deeper than this no value is made of others. */
const MAX_DEPTH = 4;

/** What a format allows, by its schema: which keys there are beside those that a text has. */
export class Schema {
  constructor(private readonly root: Node) {}

  /** The keys that a table can still be given; `present`: those that it has. */
  addable(path: string, present: string[]): Addable[] {
    const tables = this.at(path).filter((node) => node.properties && present.every((key) => node.properties?.[key]));
    const [table] = tables;
    // Where several kinds of table are possible and nothing says which, none is meant.
    if (!table?.properties || (tables.length > 1 && present.length === 0)) return [];
    // A table whose one key says its kind has no second one.
    const { properties } = table;
    return Object.entries(properties).flatMap(([key, node]) => {
      const value = present.includes(key) ? null : this.start(node, 0);
      return value === null ? [] : [{ key, value, help: this.help(node) }];
    });
  }

  /** What the format says of a key. */
  describe(path: string): string {
    const parts = path.split('.');
    const key = parts.pop() ?? '';
    const node = this.at(parts.join('.')).map(({ properties }) => properties?.[key]).find((of) => of !== undefined);
    return node ? this.help(node) : '';
  }

  private help(node: Node): string {
    const text = node.description ?? this.kinds(node).find((of) => of.description)?.description ?? '';
    return text.replaceAll('\n', ' ');
  }

  /** The kinds of value that may stand at a path of tables, lists counted from 0. */
  private at(path: string): Node[] {
    let nodes = this.kinds(this.root);
    for (const part of path === '' ? [] : path.split('.')) {
      nodes = nodes.flatMap((node) => {
        const next = /^\d+$/.test(part) ? node.items : (node.properties?.[part] ?? (typeof node.additionalProperties === 'object' ? node.additionalProperties : undefined));
        return next ? this.kinds(next) : [];
      });
    }
    return nodes;
  }

  /** References and choices resolved; that a value may be missing is none of its kinds. */
  private kinds(node: Node): Node[] {
    if (node.$ref) {
      const of = this.root.$defs?.[node.$ref.replace('#/$defs/', '')];
      return of ? this.kinds(of) : [];
    }
    const among = node.anyOf ?? node.oneOf;
    if (among) return among.flatMap((of) => this.kinds(of));
    return node.type === 'null' ? [] : [node];
  }

  /** A value to begin with, as TOML: the default, or the simplest one that is allowed; none for what only the text can have. */
  private start(node: Node, depth: number): string | null {
    if (depth > MAX_DEPTH) return null;
    if (node.default !== undefined && node.default !== null && typeof node.default !== 'object') return JSON.stringify(node.default);
    for (const kind of this.kinds(node)) {
      const value = this.simplest(kind, depth);
      if (value !== null) return value;
    }
    return null;
  }

  private simplest(kind: Node, depth: number): string | null {
    if (kind.const !== undefined) return JSON.stringify(kind.const);
    if (kind.enum?.[0] !== undefined) return JSON.stringify(kind.enum[0]);
    switch ([kind.type].flat().find((of) => of !== 'null')) {
      case 'boolean':
        return 'false';
      case 'number':
      case 'integer':
        return String(kind.exclusiveMinimum === undefined ? (kind.minimum ?? 0) : kind.exclusiveMinimum + 1);
      case 'string':
        return '""';
      case 'array':
        return this.simplestList(kind);
      case 'object':
        return this.simplestTable(kind, depth);
      default:
        return null;
    }
  }

  /** Three numbers: a direction along z, which no other list of numbers minds. */
  private simplestList(kind: Node): string | null {
    const numbers = kind.items && this.kinds(kind.items).every((of) => of.type === 'number');
    return numbers && kind.minItems === 3 ? '[0, 0, 1]' : null;
  }

  private simplestTable(kind: Node, depth: number): string | null {
    const needed = (kind.required ?? []).map((key) => {
      const of = kind.properties?.[key];
      const value = of ? this.start(of, depth + 1) : null;
      return value === null ? null : `${key} = ${value}`;
    });
    return needed.includes(null) ? null : needed.length === 0 ? '{}' : `{ ${needed.join(', ')} }`;
  }
}

/** The schema of a text: of a program, which has passes, or of a job. It is large, so it comes when a form is opened. */
export async function schemaOf(program: boolean): Promise<Schema> {
  const { default: root } = program ? await import('../../../docs/schema/program.json') : await import('../../../docs/schema/job.json');
  return new Schema(root as unknown as Node);
}
