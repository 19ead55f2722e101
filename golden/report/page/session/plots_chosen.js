// The channels of single bodies and pairs that are plotted in the timeline: those of session A that a person chose.
import { owner_lane } from "./lanes.js";

const kMost = 8;

export class Plots {
  constructor(page) {
    this.page = page;
    this.chosen = new Map();  // by channel and owner: {channel, a, b, lane}
  }

  key(channel, a, b) { return `${channel} ${Math.min(a, b || a)} ${b ? Math.max(a, b) : 0}`; }
  has(channel, a, b) { return this.chosen.has(this.key(channel, a, b)); }
  lanes() { return [...this.chosen.values()].map(({ lane }) => lane); }

  /// Plots a channel of a body (b: 0) or a pair, or takes it away; the oldest goes where there are too many.
  flip(channel, a, b) {
    const key = this.key(channel, a, b);
    if (!this.chosen.delete(key)) {
      const [{ rows, bodies }] = this.page.sessions;
      const { name, unit } = rows.channel_heads[channel];
      const whose = b ? `${bodies.label(a)} and ${bodies.label(b)}` : bodies.label(a);
      const history = { step: [], value: [] };
      this.chosen.set(key, { channel, a, b, history, lane: owner_lane(`${name} of ${whose}`, unit, history) });
      if (this.chosen.size > kMost) {
        const [[oldest, { lane }]] = this.chosen;
        this.chosen.delete(oldest);
        this.page.tell(`${kMost} channels are plotted at most; gone is ${lane.title}`);
      }
      this.read(key);
    }
    this.page.set_lanes();
  }

  /// Reads what the log has by now, and draws it part by part.
  async read(key) {
    const { channel, a, b, history } = this.chosen.get(key);
    const show = (more) => {
      Object.assign(history, { step: more.step, value: more.value });
      this.page.timeline.draw();
      return this.chosen.has(key);
    };
    try {
      show(await this.page.sessions[0].channel_history(channel, a, b, show));
    } catch (error) {
      this.page.header.trouble(error);
    }
  }

  /// The log has grown.
  again() { for (const key of this.chosen.keys()) this.read(key); }
}
