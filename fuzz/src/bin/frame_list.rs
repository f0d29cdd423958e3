#![no_main]
seamwright_fuzz::fuzz!(FRAME_LIST);
