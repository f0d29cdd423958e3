cli-more-time = { $cure }; більше часу: --time-limit S
cli-verb-renamed = примітка: `seamwright { $former }` тепер зветься `seamwright { $present }`
cli-folder-not-written = { $folder }: не вдалося записати: { $why }
cli-unknown-language = примітка: мови `{ $language }` немає, тому англійською; доступні: { $known }
