// The bodies of a session as the page knows them: a row each, in the order of the log's table.
const kKinds = ["box", "grid", "tower", "pyramid", "wall", "pile", "thrown"];
const kTextures = ["crate", "brick", "wood", "concrete", "white"];

export class BodyTable {
  /// json: as bodies_json() of the program makes it.
  constructor(json) {
    this.update(json);
  }

  update(json) {
    this.json = json;
    this.count = json.id.length;
    this.rows = new Map(json.id.map((id, row) => [id, row]));
  }

  get version() { return this.json.version; }
  id(row) { return this.json.id[row]; }
  row(id) { return this.rows.get(id); }
  size(row) { return this.json.size.slice(3 * row, 3 * row + 3); }
  is_static(row) { return this.json.static[row] === 1; }
  texture(row) { return kTextures[this.json.texture[row]] ?? ""; }

  /// As the viewer's stage takes it.
  body(row) {
    const index = this.json.shape?.[row] ?? -1;
    const shape = index < 0 ? { kind: "box" } : this.json.shapes[index];
    return { ...shape, shape: shape.kind, index, size: this.size(row) };
  }

  /// "wall 0, row 2, column 5", "thrown"; the name that the log has for it, if any.
  name(row) {
    const own = this.json.name?.[row];
    if (own) return own;
    const [kind, table, line, column] = this.json.origin.slice(4 * row, 4 * row + 4);
    const word = kKinds[kind] ?? "body";
    return kind === 0 || kind === 6 ? word : `${word} ${table}, row ${line}, column ${column}`;
  }

  /// Rows whose id or name answers to a text.
  find(text) {
    const wanted = text.trim().toLowerCase().replace(/^(body|#)\s*/, "");
    if (/^\d+$/.test(wanted)) {
      const row = this.row(Number(wanted));
      return row === undefined ? [] : [row];
    }
    const found = [];
    for (let row = 0; row < this.count; ++row) if (this.name(row).toLowerCase().includes(wanted)) found.push(row);
    return found;
  }
}
