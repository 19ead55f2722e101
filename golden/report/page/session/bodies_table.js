// The bodies of a session as the page knows them: a row each, in the order of the log's table.
const kKinds = ["box", "grid", "tower", "pyramid", "wall", "pile", "thrown"];
const kIdsOfNames = 2 ** 52;  // ids from here on were made from names
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

  /// "sphere of radius 0.5 m", "hull of 12 points, 1 × 2 × 1 m", "1 × 1 × 1 m" of a box.
  shape_words(row) {
    const size = this.size(row);
    const edges = size[0] > 0 ? `${size.map((edge) => Number(edge.toPrecision(4))).join(" × ")} m` : "size unknown";
    const shape = this.json.shapes?.[this.json.shape?.[row] ?? -1];
    if (!shape) return edges;
    return shape.points.length > 0 ? `${shape.words}, ${edges}` : shape.words;
  }

  /// As the viewer's stage takes it.
  body(row) {
    const index = this.json.shape?.[row] ?? -1;
    const shape = index < 0 ? { kind: "box" } : this.json.shapes[index];
    return { ...shape, shape: shape.kind, index, size: this.size(row) };
  }

  /// "wall 0, row 2, column 5", "thrown", "box", "sphere"; the name that the log has for it, if any.
  name(row) {
    const own = this.json.name?.[row];
    if (own) return own;
    const [kind, table, line, column] = this.json.origin.slice(4 * row, 4 * row + 4);
    const shape = this.json.shapes?.[this.json.shape?.[row] ?? -1];
    const word = kind === 0 && shape ? shape.kind : kKinds[kind] ?? "body";
    return kind === 0 || kind === 6 ? word : `${word} ${table}, row ${line}, column ${column}`;
  }

  /// "body 7", "body 7 (wheel)"; the name alone of a body that its log knows by name only.
  label(id) {
    const row = this.rows.get(id);
    const own = row === undefined ? "" : this.json.name?.[row] ?? "";
    if (own === "") return `body ${id}`;
    return id >= kIdsOfNames ? own : `body ${id} (${own})`;
  }

  /// Likewise, as short as can be: "7", "wheel".
  short(id) {
    const row = this.rows.get(id);
    const own = row === undefined ? "" : this.json.name?.[row] ?? "";
    return own !== "" && id >= kIdsOfNames ? own : String(id);
  }

  /// Rows whose id or name answers to a text.
  find(text) {
    const wanted = text.trim().toLowerCase().replace(/^(body|#)\s*/, "");
    if (/^\d+$/.test(wanted)) {
      const row = this.row(Number(wanted));
      return row === undefined ? [] : [row];
    }
    const exact = [...this.rows.values()].filter((row) => this.json.name?.[row]?.toLowerCase() === wanted);
    if (exact.length > 0) return exact;
    const found = [];
    for (let row = 0; row < this.count; ++row) if (this.name(row).toLowerCase().includes(wanted)) found.push(row);
    return found;
  }
}
