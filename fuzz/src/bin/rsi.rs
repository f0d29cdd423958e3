#![no_main]
seamwright_fuzz::fuzz!(RSI);
