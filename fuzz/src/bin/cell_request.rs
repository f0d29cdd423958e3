#![no_main]
seamwright_fuzz::fuzz!(CELL_REQUEST);
