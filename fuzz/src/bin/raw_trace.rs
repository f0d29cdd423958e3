#![no_main]
seamwright_fuzz::fuzz!(RAW_TRACE);
