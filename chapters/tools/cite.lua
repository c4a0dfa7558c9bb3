-- cite.lua -- links citations, numbers of equations and chapters in the text.
--
-- `anchors` is a file with one "(9.1) 09-drag.html", "Saad03 references.html" or
-- "Chapter-9 09-drag.html" a line: everything that may be linked to by its name.

local page_of = {}
local document = { SX15 = true, XS11 = true, LS = true, EW18 = true }

local function read_anchors(meta)
  for line in io.lines(pandoc.utils.stringify(meta.anchors)) do
    local name, page = line:match("^(%S+) (%S+)$")
    page_of[name] = page
  end
end

local function equation_id(number) return "eq-" .. number:gsub("%.", "-") end

-- "[XS11 2.13]", "[XS11 (2.11), (2.12)]", "[Saad03, 9.5]": where it leads.
local function cited(text)
  local key, place = text:match("^%[([A-Z]%w+)[%s,]*(.-)%]")
  if document[key] then
    place = place:gsub("[()]", "")
    local number = place:match("^[AB]%.%d+%a?") or place:match("^%d[%d.]*%a?")
    if place:match("^Algorithm") then number = "Algorithm 3.1" end
    local id = number and (key .. " " .. number):lower():gsub("[ .]", "-")
    return id and page_of[id] and page_of[id] .. "#" .. id
      or "references.html#" .. key
  end
  return key and page_of[key] and "references.html#" .. key
end

-- Links citations and, outside of them, numbers of equations.
local function inlines(list)
  local out, i = pandoc.List(), 1
  while i <= #list do
    local item = list[i]
    local done = false
    if item.t == "Str" and item.text:match("^%(?%[[A-Z]%w+") then
      local last = i
      while last < #list and not (list[last].t == "Str" and list[last].text:find("%]")) do
        last = last + 1
      end
      local words = {}
      for k = i, last do words[#words + 1] = pandoc.utils.stringify(list[k]) end
      local text = table.concat(words, ""):gsub("\n", " ")
      local before, core, after = text:match("^(%(?)(%[.-%])(.*)$")
      local target = core and cited(core)
      if target then
        out:extend({ pandoc.Str(before), pandoc.Link(core, target), pandoc.Str(after) })
        i = last + 1
        done = true
      end
    end
    local chapter = item.t == "Str" and item.text == "Chapter" and list[i + 2]
      and list[i + 2].t == "Str" and list[i + 2].text:match("^%d+")
    if chapter and page_of["Chapter-" .. chapter] then -- "Chapter 8," and so on
      out:insert(pandoc.Link("Chapter " .. chapter, page_of["Chapter-" .. chapter]))
      out:insert(pandoc.Str(list[i + 2].text:sub(#chapter + 1)))
      i = i + 3
    elseif not done then
      local before, number, after
      if item.t == "Str" then
        before, number, after = item.text:match("^(.-)(%(%d+%.%d+%a?%))([^%]]*)$")
      end
      if number and page_of[number] then
        local id = equation_id(number:sub(2, -2))
        out:extend({ pandoc.Str(before),
                     pandoc.Link(number, page_of[number] .. "#" .. id),
                     pandoc.Str(after) })
      else
        out:insert(item)
      end
      i = i + 1
    end
  end
  return out
end

-- A link that the text makes itself holds no other.
local function only(item)
  return pandoc.walk_inline(item, { Link = function(inner) return inner.content end })
end

return {
  { Meta = read_anchors },
  { Inlines = inlines },
  { Link = only },
}
