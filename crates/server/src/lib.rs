//! The operator's panel: HTTP, WebSocket, users, and the cell behind them.

pub mod wire;
