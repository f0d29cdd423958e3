use serde::{Deserialize, Serialize};
use std::fmt;

/// Declares the units with their symbols, which are also their names in files.
macro_rules! units {
    ($($(#[$doc:meta])* $name:ident = $symbol:literal,)*) => {
        /// A unit of measurement.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
        pub enum Unit {
            $($(#[$doc])* #[serde(rename = $symbol)] $name,)*
        }

        impl Unit {
            /// Every unit, in the order of declaration.
            pub const ALL: &[Self] = &[$(Self::$name,)*];

            /// Symbol in ASCII, like `mm/s^2`.
            pub fn symbol(self) -> &'static str {
                match self {
                    $(Self::$name => $symbol,)*
                }
            }
        }
    };
}

units! {
    /// A number without a unit.
    One = "1",
    /// Millimetre.
    Mm = "mm",
    /// Square millimetre.
    Mm2 = "mm^2",
    /// Square metre.
    M2 = "m^2",
    /// Cubic metre.
    M3 = "m^3",
    /// Micrometre.
    Um = "um",
    /// Metre.
    M = "m",
    /// Degree.
    Deg = "deg",
    /// Per metre.
    PerM = "1/m",
    /// Radian.
    Rad = "rad",
    /// Millimetre per second.
    MmPerS = "mm/s",
    /// Millimetre per second squared.
    MmPerS2 = "mm/s^2",
    /// Millimetre per second cubed.
    MmPerS3 = "mm/s^3",
    /// Degree per second.
    DegPerS = "deg/s",
    /// Degree per second squared.
    DegPerS2 = "deg/s^2",
    /// Degree per second cubed.
    DegPerS3 = "deg/s^3",
    /// Millimetre per minute.
    MmPerMin = "mm/min",
    /// Metre per minute.
    MPerMin = "m/min",
    /// Litre per minute.
    LPerMin = "l/min",
    /// Second.
    S = "s",
    /// Millisecond.
    Ms = "ms",
    /// Microsecond.
    Us = "us",
    /// Nanosecond.
    Ns = "ns",
    /// Hertz.
    Hz = "Hz",
    /// Kilohertz.
    KiloHz = "kHz",
    /// Percent.
    Percent = "%",
    /// Ampere.
    A = "A",
    /// Milliampere.
    MilliA = "mA",
    /// Volt.
    V = "V",
    /// Kilovolt.
    KiloV = "kV",
    /// Newton.
    N = "N",
    /// Newton metre.
    NM = "N m",
    /// Watt.
    W = "W",
    /// Kilowatt.
    KiloW = "kW",
    /// Kilojoule.
    KiloJ = "kJ",
    /// Kilojoule per millimetre.
    KiloJPerMm = "kJ/mm",
    /// Millibar.
    Mbar = "mbar",
    /// Bar.
    Bar = "bar",
    /// Degree Celsius.
    DegC = "degC",
    /// Kelvin.
    K = "K",
    /// Pixel.
    Px = "px",
    /// Decibel.
    Db = "dB",
    /// Byte.
    Byte = "B",
    /// Mebibyte.
    MiB = "MiB",
}

impl Unit {
    /// The unit with this symbol.
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|unit| unit.symbol() == symbol)
    }

    /// Identifier of the unit in catalogues, like `unit-mm-per-s2`.
    pub fn identifier(self) -> String {
        let name = self.symbol().replace('/', "-per-").replace('^', "").replace('%', "percent").replace(' ', "-");
        format!("unit-{name}")
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.symbol())
    }
}
