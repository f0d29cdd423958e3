/// Value of a file with the key at which the file has it.
#[derive(Debug, Clone, Copy)]
pub struct Keyed<'a, T> {
    /// Address of the value in the file.
    pub key: &'a str,
    /// The value.
    pub value: &'a T,
}
