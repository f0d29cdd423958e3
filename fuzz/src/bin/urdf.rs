#![no_main]
seamwright_fuzz::fuzz!(URDF);
