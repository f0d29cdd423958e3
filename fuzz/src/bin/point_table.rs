#![no_main]
seamwright_fuzz::fuzz!(POINT_TABLE);
