#![no_main]
seamwright_fuzz::fuzz!(REQUEST_BODY);
