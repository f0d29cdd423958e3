//! Reports: plots as SVG and one self-contained HTML page.
