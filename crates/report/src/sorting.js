document.querySelectorAll("table.sortable").forEach(function(table){
var body=table.tBodies[0];
Array.prototype.forEach.call(table.tHead.rows[0].cells,function(head,i){
head.tabIndex=0;
var numeric=head.classList.contains("number");
function value(row){var text=row.cells[i].textContent;return numeric?parseFloat(text.replace("\u2212","-").replace(/[\s\u202f]/g,"").replace(",","."))||0:text;}
function sort(){
var down=head.getAttribute("aria-sort")==="ascending";
Array.prototype.forEach.call(table.tHead.rows[0].cells,function(other){other.removeAttribute("aria-sort");});
head.setAttribute("aria-sort",down?"descending":"ascending");
Array.from(body.rows).sort(function(a,b){
var x=value(a),y=value(b),order=numeric?x-y:x.localeCompare(y,undefined,{numeric:true});
return down?-order:order;
}).forEach(function(row){body.appendChild(row);});
}
head.addEventListener("click",sort);
head.addEventListener("keydown",function(event){if(event.key==="Enter"){sort();}});
});
});
