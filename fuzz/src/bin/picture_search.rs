#![no_main]
seamwright_fuzz::fuzz!(PICTURE_SEARCH);
