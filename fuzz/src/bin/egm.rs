#![no_main]
seamwright_fuzz::fuzz!(EGM);
