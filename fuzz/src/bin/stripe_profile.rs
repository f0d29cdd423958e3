#![no_main]
seamwright_fuzz::fuzz!(STRIPE_PROFILE);
