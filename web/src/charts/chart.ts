import uPlot from 'uplot';
import { colour } from '../panel/theme.svelte';
import { ends } from './axis_range';

/** A line of a chart. */
export type Line = { name: string; colour: string; dashed?: boolean; /** Draws over places without a value. */ joined?: boolean };

export type ChartSettings = {
  lines: Line[];
  /** Unit of the horizontal axis, `s`, `mm` or `Hz`. */
  unit: string;
  /** Fixed ends of the horizontal axis; else those of the data. */
  from?: number;
  to?: number;
  /** The horizontal axis is logarithmic. */
  logarithmic?: boolean;
  /** The least height of the vertical axis: noise of the last digit shall not fill the chart. */
  least?: number;
  /** The vertical axis begins at 0. */
  zero?: boolean;
  /** Called with the index under the cursor, or null. */
  cursor?: (index: number | null) => void;
  /** Called when a place is pressed. */
  pick?: (index: number) => void;
  /** Charts with the same name share their cursor. */
  together?: string;
};

/** A chart that fills its element and follows its size. It is written to directly; the framework never sees its points. */
export class Chart {
  private readonly plot: uPlot;
  private readonly watch: ResizeObserver;

  constructor(
    private readonly place: HTMLElement,
    settings: ChartSettings,
  ) {
    this.plot = new uPlot(this.options(settings), [[], ...settings.lines.map(() => [])], place);
    this.watch = new ResizeObserver(() => this.plot.setSize(this.size()));
    this.watch.observe(place);
    const { pick } = settings;
    if (pick) {
      this.plot.over.addEventListener('click', () => {
        if (this.plot.cursor.idx != null) pick(this.plot.cursor.idx);
      });
    }
  }

  set(data: (number | null)[][]): void {
    this.plot.setData(data as uPlot.AlignedData);
  }

  /** Index under the cursor, or null. */
  get under(): number | null {
    return this.plot.cursor.idx ?? null;
  }

  /** Puts the cursor to a place on the horizontal axis. */
  point(x: number | null): void {
    if (x === null) this.plot.setCursor({ left: -10, top: -10 }, false);
    else this.plot.setCursor({ left: this.plot.valToPos(x, 'x'), top: 4 }, false);
  }

  end(): void {
    this.watch.disconnect();
    this.plot.destroy();
  }

  private size(): { width: number; height: number } {
    return { width: Math.max(60, this.place.clientWidth), height: Math.max(50, this.place.clientHeight) };
  }

  private options(settings: ChartSettings): uPlot.Options {
    const axis = { stroke: colour('quiet'), grid: { stroke: colour('grid'), width: 1 }, ticks: { show: false }, font: '11px system-ui' };
    const { from, to } = settings;
    return {
      ...this.size(),
      legend: { show: false },
      cursor: {
        y: false,
        drag: { x: false, y: false },
        points: { size: 6 },
        ...(settings.together ? { sync: { key: settings.together } } : {}),
      },
      scales: {
        x: { time: false, ...(settings.logarithmic ? { distr: 3 as const } : {}), ...(from !== undefined && to !== undefined ? { range: [from, to] as [number, number] } : {}) },
        y: { range: (_, least, most) => ends(least, most, settings.least ?? 0, settings.zero) },
      },
      axes: [
        { ...axis, size: 20, space: 60, values: (_, ticks) => ticks.map((tick: number | null) => (tick === null ? '' : plain(tick))) },
        { ...axis, size: 44, space: 24, values: (_, ticks) => ticks.map(plain) },
      ],
      series: [
        {},
        ...settings.lines.map((line) => ({
          stroke: colour(line.colour),
          width: 1.5,
          points: { show: false },
          spanGaps: line.joined ?? false,
          ...(line.dashed ? { dash: [5, 4] } : {}),
        })),
      ],
      hooks: { setCursor: [(plot) => settings.cursor?.(plot.cursor.idx ?? null)] },
    };
  }
}

function plain(value: number): string {
  return String(Number(value.toPrecision(4))).replace('-', '\u2212');
}
