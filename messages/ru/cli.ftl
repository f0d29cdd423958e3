cli-more-time = { $cure }; больше времени: --time-limit S
cli-verb-renamed = примечание: `seamwright { $former }` теперь называется `seamwright { $present }`
cli-folder-not-written = { $folder }: не удалось записать: { $why }
cli-unknown-language = примечание: языка `{ $language }` нет, поэтому по-английски; доступны: { $known }
