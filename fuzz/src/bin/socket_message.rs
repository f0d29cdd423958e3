#![no_main]
seamwright_fuzz::fuzz!(SOCKET_MESSAGE);
