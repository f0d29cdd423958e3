//! Writing of SVG elements.

use crate::glyph::Point;
use crate::number::px;
use crate::text::{minus, printable, width};
use crate::{Language, style};
use maud::{Markup, PreEscaped, html};
use seamwright_message::{Message, Unit};

/// Width of every drawing, px; one px is one CSS pixel at 100 %.
pub(crate) const WIDTH: f64 = 920.0;

/// Room for the stroke of a frame at the right edge, px.
pub(crate) const EDGE: f64 = 0.5;

/// Margin around a standalone drawing, px.
const MARGIN: f64 = 16.0;

/// A rectangle in px, y down.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Rect {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) w: f64,
    pub(crate) h: f64,
}

impl Rect {
    pub(crate) fn right(&self) -> f64 {
        self.x + self.w
    }

    pub(crate) fn bottom(&self) -> f64 {
        self.y + self.h
    }

    pub(crate) fn around(p: Point, half: f64) -> Self {
        Self { x: p.0 - half, y: p.1 - half, w: 2.0 * half, h: 2.0 * half }
    }

    pub(crate) fn nearest(&self, p: Point) -> Point {
        (p.0.clamp(self.x, self.right()), p.1.clamp(self.y, self.bottom()))
    }

    pub(crate) fn inset(&self, by: f64) -> Self {
        Self { x: self.x + by, y: self.y + by, w: (self.w - 2.0 * by).max(1.0), h: (self.h - 2.0 * by).max(1.0) }
    }
}

/// A drawing.
pub trait Drawing {
    /// Returns the elements and their height, px.
    #[doc(hidden)]
    fn draw(&self) -> (Svg, f64);

    /// Returns the title, or a name for the kind of drawing.
    fn label(&self) -> String;

    /// Returns the drawing for a [`Page`](crate::Page), which carries the styles.
    fn to_svg(&self) -> String {
        let (svg, height) = self.draw();
        svg.inline(height, &self.label())
    }

    /// Returns the drawing as a file of its own, with styles for light and dark, and a background.
    fn to_svg_standalone(&self) -> String {
        let (svg, height) = self.draw();
        svg.standalone(height, &self.label())
    }
}

/// Position of text relative to its point.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// A drawing under construction.
#[derive(Debug, Default)]
pub struct Svg {
    body: String,
}

impl Svg {
    fn add(&mut self, element: Markup) {
        self.body += &element.into_string();
        self.body.push('\n');
    }

    pub(crate) fn line(&mut self, class: &str, x1: f64, y1: f64, x2: f64, y2: f64) {
        self.path(class, &format!("M{},{} {},{}", px(x1), px(y1), px(x2), px(y2)));
    }

    pub(crate) fn path(&mut self, class: &str, d: &str) {
        if !d.is_empty() {
            self.add(html! { path class=(class) d=(PreEscaped(d)) {} });
        }
    }

    pub(crate) fn rect(&mut self, class: &str, r: Rect) {
        self.add(html! { rect class=(class) x=(px(r.x)) y=(px(r.y)) width=(px(r.w)) height=(px(r.h)) {} });
    }

    pub(crate) fn circle(&mut self, class: &str, x: f64, y: f64, radius: f64) {
        self.add(html! { circle class=(class) cx=(px(x)) cy=(px(y)) r=(px(radius)) {} });
    }

    /// Writes text on a baseline, numbers with a true minus.
    pub(crate) fn text(&mut self, class: &str, x: f64, y: f64, anchor: Anchor, text: &str) {
        let anchor = match anchor {
            Anchor::Start => None,
            Anchor::Middle => Some("middle"),
            Anchor::End => Some("end"),
        };
        if !text.is_empty() {
            self.add(html! { text class=(class) x=(px(x)) y=(px(y)) text-anchor=[anchor] { (minus(text)) } });
        }
    }

    /// Writes tick labels centred below their ticks, or as far right as the drawing goes. Omits labels that would
    /// overlap the previous one.
    pub(crate) fn ticks(&mut self, y: f64, ticks: impl Iterator<Item = (f64, String)>) {
        let mut before: Option<(f64, f64)> = None;
        for (x, label) in ticks {
            let half = 0.5 * width(&minus(&label), 11.0);
            let x = x.min(WIDTH - half);
            if before.is_none_or(|(other, room)| (x - other).abs() > room + half) {
                self.text("tick", x, y, Anchor::Middle, &label);
                before = Some((x, half + 3.0));
            }
        }
    }

    /// Draws a bar of a round length in the lower left corner of `frame`; `scale` is px per mm, and `unit` its name.
    pub(crate) fn scale_bar(&mut self, frame: Rect, scale: f64, language: Language) {
        let wanted = 0.2 * frame.w / scale;
        let power = 10_f64.powf(wanted.log10().floor());
        let mm = [5.0, 2.0, 1.0].into_iter().map(|k| k * power).find(|mm| *mm <= wanted).unwrap_or(power);
        let (x, y) = (frame.x + 8.0, frame.bottom() - 8.0);
        let length = Message::new("quantity").value("value", mm, Unit::Mm);
        self.line("line thin c6", x, y, x + mm * scale, y);
        self.text("tick halo", x + mm * scale + 5.0, y + 3.5, Anchor::Start, &length.in_language(language));
    }

    pub(crate) fn clipped(&mut self, r: Rect, draw: impl FnOnce(&mut Self)) {
        let mut inside = Self::default();
        draw(&mut inside);
        let (x, y, w, h) = (px(r.x), px(r.y), px(r.w), px(r.h));
        let view = format!("{x} {y} {w} {h}");
        self.add(html! {
            svg x=(x) y=(y) width=(w) height=(h) viewBox=(view) overflow="hidden" { (PreEscaped(inside.body)) }
        });
    }

    /// Inserts another drawing, moved down by `y` px.
    pub(crate) fn place(&mut self, other: &Self, y: f64) {
        let moved = format!("translate(0,{})", px(y));
        self.add(html! { g transform=(moved) { (PreEscaped(&other.body)) } });
    }

    /// Returns the element for a page that carries the styles.
    pub(crate) fn inline(self, height: f64, label: &str) -> String {
        let (w, h) = (px(WIDTH), px(height));
        let view = format!("0 0 {w} {h}");
        let element = html! {
            svg class="plot" viewBox=(view) width=(w) height=(h) role="img" aria-label=(label) {
                "\n" (PreEscaped(self.body))
            }
        };
        printable(element.0 + "\n")
    }

    /// Returns a file of its own, with styles, title and background.
    pub(crate) fn standalone(self, height: f64, label: &str) -> String {
        let sheet = Rect { x: -MARGIN, y: -MARGIN, w: WIDTH + 2.0 * MARGIN, h: height + 2.0 * MARGIN };
        let mut back = Self::default();
        back.rect("back", sheet);
        let (x, w, h) = (px(sheet.x), px(sheet.w), px(sheet.h));
        let view = format!("{x} {x} {w} {h}");
        let element = html! {
            svg xmlns="http://www.w3.org/2000/svg" class="plot" viewBox=(view) width=(w) height=(h) {
                title { (label) }
                style { (PreEscaped(style::svg_sheet())) }
                (PreEscaped(back.body)) (PreEscaped(self.body))
            }
        };
        printable(element.0 + "\n")
    }
}
